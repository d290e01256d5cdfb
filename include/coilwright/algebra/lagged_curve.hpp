#pragma once

#include <span>
#include <utility>
#include <vector>

#include "coilwright/algebra/smooth_curve.hpp"

namespace coilwright::algebra {

/// The response of a first-order lag to a curve: x' = (u(t) - x) / T, in closed form. On each of the cubics of u it is
/// the polynomial u - T u' + T^2 u'' - T^3 u''' and a part that fades as exp(-t / T).
class LaggedCurve {
 public:
  /// Applies the lag T (s, > 0) to the curve `entering`, from `start` at the first row, one value for each of the
  /// curve's. Rounding grows as the cube of T over the time between rows: 1e-13 of the curve at a ratio of ten.
  LaggedCurve(SmoothCurve entering, double lag, std::span<const double> start);

  /// Writes the values at a time (s) that is not before the first row.
  void at(double time, std::span<double> out) const;

 private:
  [[nodiscard]] double following(std::size_t interval, std::size_t column, double since) const;

  SmoothCurve entering_;
  double lag_;
  std::vector<double> fading_;  // at the rows, less the last one
};

}  // namespace coilwright::algebra
