#pragma once

#include <optional>
#include <vector>

#include "coilwright/actuator/model/torque_correction.hpp"
#include "coilwright/actuator/parts/torque_curve_error.hpp"

namespace coilwright::actuator {

struct ModelSpec;

/// Small differences between a built actuator and its file that a fit of its motion finds and that no number of a
/// drawing expresses.
struct AsBuilt {
  std::optional<TorqueCurveError> force_curve{};  ///< of every coil and magnet across a joint
  /// Difference of the joints' stiffness over their mean, -2 to 2: the first joint has 1 - r/2 of its own stiffness,
  /// the second 1 + r/2, and so on in turn.
  double joint_stiffness_ratio = 0.0;
  double joint_damping_ratio = 0.0;  ///< difference of the joints' damping over their mean, in the same sense
  double face_closing_shift = 0.0;   ///< added to the angle at which the faces of every joint touch, rad
  std::optional<TorqueCorrection> torque_correction{};  ///< a torque that no effect explains
  /// Factors of single joints and magnets, from the base; empty: 1 each. Files do not have them; a build of a study's
  /// spread draws them. @{
  std::vector<double> joint_stiffness_factors{};
  std::vector<double> remanence_factors{};
  ///@}
  friend bool operator==(const AsBuilt&, const AsBuilt&) = default;
};

/// The model of `spec` with these differences. Throws std::invalid_argument naming a ratio outside -2 to 2 and for
/// another number of factors than of parts, and as with_error().
[[nodiscard]] ModelSpec as_built(ModelSpec spec, const AsBuilt& differences);

}  // namespace coilwright::actuator
