#pragma once

#include <optional>
#include <vector>

#include "coilwright/actuator/model/torque_correction.hpp"
#include "coilwright/actuator/parts/torque_curve_error.hpp"

namespace coilwright::actuator {

struct ModelSpec;

/// How an actuator as it was built differs from what its numbers give: small differences that a fit of its motion finds
/// and that no number of a drawing can say.
struct AsBuilt {
  std::optional<TorqueCurveError> force_curve{};  ///< of every coil and magnet across a joint
  /// Difference of the joints' stiffness over their mean: the first joint has 1 - r/2 of its own, the second 1 + r/2,
  /// and so on in turn; -2 to 2.
  double joint_stiffness_ratio = 0.0;
  double joint_damping_ratio = 0.0;  ///< the same of their damping
  double face_closing_shift = 0.0;   ///< added to the angle at which the faces of every joint touch, rad
  std::optional<TorqueCorrection> torque_correction{};  ///< what no effect explains
  /// Of one joint and one magnet over what the design gives all alike, from the base; none: 1 each. No file says them:
  /// they are what one build of a study's spread has drawn.
  ///@{
  std::vector<double> joint_stiffness_factors{};
  std::vector<double> remanence_factors{};
  ///@}
  friend bool operator==(const AsBuilt&, const AsBuilt&) = default;
};

/// The model of `spec` as it was built. Throws std::invalid_argument naming a ratio outside -2 to 2, factors of fewer
/// or more parts than there are, and as with_error().
[[nodiscard]] ModelSpec as_built(ModelSpec spec, const AsBuilt& differences);

}  // namespace coilwright::actuator
