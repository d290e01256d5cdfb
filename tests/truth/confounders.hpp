#pragma once

#include <string>
#include <vector>

#include "truth/experiments.hpp"
#include "truth/recording.hpp"

namespace truth {

/// An effect is visible if it changes all samples together by at least so many standard deviations of the noise.
inline constexpr double visible = 6.0;

/// The motion of a finger with one hidden effect, whose confounders are searched.
struct ConfounderRequest {
  std::string id;
  Camera camera{};
  Finger finger;
  const std::vector<Experiment>& runs;
  const RecordedAngles& nominal;  ///< without the effect
  const RecordedAngles& moved;    ///< with it
  double noise{};                 ///< rad
};

/// Ids of other effects of the catalogue that these data cannot distinguish from the hidden one: with their best
/// strength and with stiffness and damping fitted they leave less than six standard deviations of the noise over all
/// samples. Computed to first order in their strength, for a few of their signs and shapes: there may be more
/// confounders, but not fewer if the motion is nearly linear.
[[nodiscard]] std::vector<std::string> confounders_of(const ConfounderRequest& request);

}  // namespace truth
