#pragma once

#include <functional>
#include <string>
#include <vector>

#include "coilwright/actuator/model/model.hpp"
#include "coilwright/control/arrival.hpp"
#include "coilwright/control/current_profile.hpp"
#include "coilwright/simulation/modes.hpp"

namespace coilwright::control {

/// Reach a bending angle from rest, fast and without ringing, by a current profile alone (no sensor).
struct ReachTask {
  double angle{};                ///< to reach, rad
  double start_current{};        ///< in every coil before, A
  double lowest_current{};       ///< that the driver gives, A
  double highest_current{};      ///< A; > lowest_current
  double stiffness_error = 0.1;  ///< by how much k of all hinges may be off, relative; 0 to 0.5
  double damping_error = 0.1;    ///< b likewise
  int pieces = 3;                ///< levels of the searched profile before the last one, 1 to 6
};

/// A profile and how it does.
struct ProfileQuality {
  std::string name;  ///< "step", "zero_vibration", "zero_vibration_derivative", "searched"
  CurrentProfile profile;
  Arrival nominal;
  /// The latest arrival of the finger as it is and with k and b off either way; its overshoot is the largest of theirs.
  Arrival worst;
};

/// The answer.
struct Reach {
  double current{};                      ///< that holds the angle, A
  simulation::Mode mode;                 ///< the slowest of small motions there
  double duration{};                     ///< for which every profile was followed, s
  std::vector<ProfileQuality> profiles;  ///< step, the two shapers, searched; at least the step
  double least_end{};                    ///< bending angle at which fingers with k and b off end, rad
  double greatest_end{};                 ///< likewise: no profile without a sensor mends it
};

/// Finds the current that holds the angle, shapes a step to it for the slowest mode, and searches with NLopt (Nelder
/// and Mead on subspaces, from both shapers and from the highest current) the levels and lengths of a profile whose
/// worst Arrival::time_outside over the five fingers is least. Same task, same answer. Throws std::invalid_argument
/// naming the field, the rule and the value, and std::runtime_error saying why where the angle cannot be reached or the
/// plain step does not settle.
[[nodiscard]] Reach reach(const actuator::Model& model, const ReachTask& task);

/// The profile whose worst finger settles first; the earlier one of equals. A fling that is over soon still is one:
/// more overshoot than most_overshoot comes after any that keeps within it.
[[nodiscard]] const ProfileQuality& best_profile(const Reach& reach);

}  // namespace coilwright::control
