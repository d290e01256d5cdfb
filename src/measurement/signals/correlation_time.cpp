#include "coilwright/measurement/signals/correlation_time.hpp"

#include <algorithm>

namespace coilwright::measurement::signals {
namespace {

struct Window {
  const double* values;
  std::size_t size;
};

std::vector<Window> windows_of(std::span<const ScaledResidual> residuals) {
  std::vector<Window> windows;
  for (const ScaledResidual& residual : residuals)
    for (std::size_t w = 0; w < residual.starts.size(); ++w) {
      const std::size_t end = w + 1 < residual.starts.size() ? residual.starts[w + 1] : residual.values.size();
      windows.push_back({residual.values.data() + residual.starts[w], end - residual.starts[w]});
    }
  return windows;
}

}  // namespace

double correlation_time(std::span<const ScaledResidual> residuals) {
  validate_residuals(residuals);
  const std::vector<Window> windows = windows_of(residuals);
  std::size_t longest = 0;
  double energy = 0.0;
  double samples = 0.0;
  for (const Window& window : windows) {
    longest = std::max(longest, window.size);
    samples += static_cast<double>(window.size);
    for (std::size_t i = 0; i < window.size; ++i) energy += window.values[i] * window.values[i];
  }
  if (energy <= 0.0) return 1.0;

  double time = 1.0;
  constexpr double truncation = 5.0;  // correlation times
  for (std::size_t lag = 1; lag < longest && static_cast<double>(lag) < truncation * std::max(time, 1.0); ++lag) {
    double sum = 0.0;
    for (const Window& window : windows)
      for (std::size_t i = lag; i < window.size; ++i) sum += window.values[i] * window.values[i - lag];
    // Divided by the number of all samples, not of the pairs at this lag: long lags, which are less certain, weigh
    // less.
    time += 2.0 * sum / energy;
  }
  return std::clamp(time, 1.0, samples);
}

}  // namespace coilwright::measurement::signals
