#include "coilwright/algebra/lagged_curve.hpp"

#include <cmath>

namespace coilwright::algebra {

LaggedCurve::LaggedCurve(SmoothCurve entering, double lag, std::span<const double> start)
    : entering_(std::move(entering)), lag_(lag), fading_(entering_.width() * (entering_.times().size() - 1)) {
  const std::span<const double> times = entering_.times();
  const std::size_t width = entering_.width();
  std::vector<double> now(start.begin(), start.end());
  for (std::size_t i = 0; i + 1 < times.size(); ++i) {
    const double step = times[i + 1] - times[i];
    const double left = std::exp(-step / lag_);
    for (std::size_t c = 0; c < width; ++c) {
      double& fading = fading_[i * width + c];
      fading = now[c] - following(i, c, 0.0);
      now[c] = following(i, c, step) + left * fading;
    }
  }
}

// The polynomial, so long after the row at which the interval begins.
double LaggedCurve::following(std::size_t interval, std::size_t column, double since) const {
  const SmoothCurve::Cubic& u = entering_.cubic(interval, column);
  const double slope = u.slope + since * (2.0 * u.bend + since * 3.0 * u.twist);
  const double second = 2.0 * u.bend + since * 6.0 * u.twist;
  return u.value + since * (u.slope + since * (u.bend + since * u.twist)) -
         lag_ * (slope - lag_ * (second - lag_ * 6.0 * u.twist));
}

void LaggedCurve::at(double time, std::span<double> out) const {
  const std::size_t interval = entering_.interval_of(time);
  const double since = time - entering_.times()[interval];
  const double left = std::exp(-since / lag_);
  for (std::size_t c = 0; c < entering_.width(); ++c)
    out[c] = following(interval, c, since) + left * fading_[interval * entering_.width() + c];
}

}  // namespace coilwright::algebra
