#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "coilwright/actuator/model/model.hpp"
#include "coilwright/control/current_profile.hpp"

namespace coilwright::control {

/// Share of the change within which a motion counts as arrived: the usual convention, which simulation::StepResponse
/// uses too.
inline constexpr double settling_band = 0.02;

/// Overshoot above which a profile counts as ringing.
inline constexpr double most_overshoot = 0.1;

/// The course of the bending angle at the end of a profile.
struct Arrival {
  double start{};  ///< rad, under the current before
  double end{};    ///< rad, the equilibrium under the last current
  std::optional<double>
      settling_time{};  ///< last time outside the band about `end`, s; absent: still outside at the end
  double overshoot{};   ///< largest excess beyond the end, over the change; >= 0
  double peak_speed{};  ///< rad/s
  /// Time outside the band with a soft edge, integral of e^2 / (e^2 + band^2), s: a smooth measure of the settling
  /// time.
  double time_outside{};

  /// The settling time, infinite if the motion does not settle; used to compare profiles.
  [[nodiscard]] double settling_or_never() const {
    return settling_time.value_or(std::numeric_limits<double>::infinity());
  }
};

/// Follows `model` under `profile` from rest for `duration` (s), with 2000 samples per second. Slow effects, such as
/// heat, stay as they are at the start. Throws std::invalid_argument for a profile that breaks its rules, and
/// std::runtime_error if the model has no stable pose at the start or at the end, or if its bending angle changes by
/// less than 1e-6 rad.
[[nodiscard]] Arrival arrival(const actuator::Model& model, const CurrentProfile& profile, double duration);

}  // namespace coilwright::control
