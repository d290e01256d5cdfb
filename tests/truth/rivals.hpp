#pragma once

#include <string>
#include <vector>

#include "truth/experiments.hpp"
#include "truth/film.hpp"

namespace truth {

/// A finger moved by one hidden effect, and what could be taken for it.
struct Suspect {
  std::string id;
  Camera camera{};
  Finger finger;
  const std::vector<Experiment>& runs;
  const Films& nominal;  ///< without the effect
  const Films& moved;    ///< with it
  double noise{};        ///< rad
};

/// Ids of other effects of the catalogue that, as strong as they need be and with stiffness and damping fitted, leave
/// less than six standard deviations of the noise over all samples: nobody could tell them apart. To first order in
/// their strength, for a handful of their signs and shapes: there may be more, never fewer where the motion is nearly
/// linear.
[[nodiscard]] std::vector<std::string> rivals_of(const Suspect& suspect);

}  // namespace truth
