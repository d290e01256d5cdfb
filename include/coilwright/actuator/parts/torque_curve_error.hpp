#pragma once

#include <array>
#include <memory>

#include "coilwright/magnetics/curve.hpp"

namespace coilwright::actuator {

/// Smooth relative error of a torque per ampere over the joint angle: the real torque is the computed one times 1 + c_0
/// + c_1 P_1(x) + c_2 P_2(x) + c_3 P_3(x), with Legendre's polynomials and x from -1 at `lower` to 1 at `upper`. Beyond
/// these ends x continues smoothly (twice differentiable) for 0.1 more, so the factor stays bounded where nothing was
/// measured.
struct TorqueCurveError {
  double lower{};                        ///< joint angle, rad
  double upper{};                        ///< rad; > lower
  std::array<double, 4> coefficients{};  ///< c_0 to c_3, dimensionless

  /// Real over computed torque at a joint angle in rad.
  [[nodiscard]] double factor(double angle) const;
  /// Whether the error is zero.
  [[nodiscard]] bool none() const { return coefficients == std::array<double, 4>{}; }
  friend bool operator==(const TorqueCurveError&, const TorqueCurveError&) = default;
};

/// Returns `curve`, of torque per ampere over the joint angle, with its error, to 1e-6 of its largest value or to four
/// times its own bound if that is more. Throws std::invalid_argument unless upper > lower.
[[nodiscard]] std::shared_ptr<const magnetics::Curve> with_error(std::shared_ptr<const magnetics::Curve> curve,
                                                                 const TorqueCurveError& error);

}  // namespace coilwright::actuator
