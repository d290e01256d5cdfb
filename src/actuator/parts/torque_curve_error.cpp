#include "coilwright/actuator/parts/torque_curve_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace coilwright::actuator {
namespace {

// How far beyond its range x goes on, in half ranges: P_3 is then 1.7 instead of growing with the third power.
constexpr double overshoot = 0.1;

double bounded(double x) {
  const double size = std::abs(x);
  if (size <= 1.0) return x;
  return std::copysign(1.0 + overshoot * std::tanh((size - 1.0) / overshoot), x);
}

}  // namespace

double TorqueCurveError::factor(double angle) const {
  const double x = bounded((2.0 * angle - lower - upper) / (upper - lower));
  const auto& c = coefficients;
  return 1.0 + c[0] + c[1] * x + c[2] * 0.5 * (3.0 * x * x - 1.0) + c[3] * 0.5 * x * (5.0 * x * x - 3.0);
}

std::shared_ptr<const magnetics::Curve> with_error(std::shared_ptr<const magnetics::Curve> curve,
                                                   const TorqueCurveError& error) {
  if (!(error.upper > error.lower))
    throw std::invalid_argument(fmt::format("range of a torque curve's error must end above its beginning ({}); got {}",
                                            error.lower, error.upper));
  if (error.none()) return curve;
  const auto product = [&](std::span<const double> angles, std::span<double> torques) {
    std::ranges::transform(angles, torques.begin(),
                           [&](double angle) { return curve->value(angle) * error.factor(angle); });
  };
  // Pieces of the curve meet within its bound only: what is noisier than the tolerance cannot be interpolated. Where
  // the third derivative jumps, at the ends of the error's range, the interpolant is worse than it believes.
  const double tolerance = std::max(1e-7, 4.0 * curve->error_bound() / curve->scale());
  return std::make_shared<const magnetics::Curve>(
      product, magnetics::Curve::Spec{.lower = curve->lower(),
                                      .upper = curve->upper(),
                                      .tolerance = tolerance,
                                      .boundary_layer_width = curve->boundary_layer_width()});
}

}  // namespace coilwright::actuator
