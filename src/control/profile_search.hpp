#pragma once

#include <vector>

#include "coilwright/actuator/model/model.hpp"
#include "coilwright/control/current_profile.hpp"

namespace coilwright::control {

/// Profiles among which the best is looked for, and from where.
struct ProfileSearch {
  double start_current{};              ///< A
  double lowest{};                     ///< A
  double highest{};                    ///< A
  double current{};                    ///< in the end, A
  int pieces{};                        ///< levels before the last, >= 1
  double longest_piece{};              ///< s
  double duration{};                   ///< for which each motion is followed, s
  std::vector<CurrentProfile> starts;  ///< from the same current to the same, of any number of pieces
};

/// The profile whose largest Arrival::time_outside over `models` is least (with a fine for more than most_overshoot),
/// by NLopt's Sbplx (Rowan's Subplex: Nelder and Mead on subspaces, which a largest of several values does not lead
/// astray as it does methods with slopes) from each start and from a push at the current limit. Never worse than the
/// best start.
[[nodiscard]] CurrentProfile search_profile(const std::vector<actuator::Model>& models, const ProfileSearch& search);

}  // namespace coilwright::control
