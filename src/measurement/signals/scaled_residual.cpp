#include "coilwright/measurement/signals/scaled_residual.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace coilwright::measurement::signals {

double ScaledResidual::freedom_below(double frequency) const {
  if (bands.empty()) return freedom;
  double sum = 0.0;
  for (const KnownBand& band : bands) {
    sum += band.freedom;
    if (band.to >= frequency) break;
  }
  return sum;
}

double ScaledResidual::freedom_at(double frequency) const {
  if (bands.empty()) return freedom;
  for (const KnownBand& band : bands)
    if (band.to >= frequency) return band.freedom;
  return bands.back().freedom;
}

void validate_residuals(std::span<const ScaledResidual> residuals) {
  for (const ScaledResidual& residual : residuals) {
    const auto require = [&](bool met, const char* rule, double value) {
      if (!met) throw std::invalid_argument(fmt::format("{}: {}; got {}", residual.run, rule, value));
    };
    const std::size_t n = residual.values.size();
    require(residual.times.empty() || residual.times.size() == n, "a residual must have one time for each value",
            static_cast<double>(residual.times.size()));
    for (std::size_t i = 1; i < residual.times.size(); ++i)
      require(residual.times[i] > residual.times[i - 1], "times of a residual must increase", residual.times[i]);
    for (const double value : residual.values) require(std::isfinite(value), "a residual must be finite", value);
    require(!residual.starts.empty() && residual.starts.front() == 0, "the first window must start at sample 0",
            residual.starts.empty() ? NAN : static_cast<double>(residual.starts.front()));
    for (std::size_t i = 1; i < residual.starts.size(); ++i)
      require(residual.starts[i] > residual.starts[i - 1] && residual.starts[i] < n,
              "starts of windows must rise and stay inside the run", static_cast<double>(residual.starts[i]));
  }
}

}  // namespace coilwright::measurement::signals
