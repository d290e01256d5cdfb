#include "measurement/signals/normalised_run.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "measurement/signals/spectrum.hpp"

namespace coilwright::measurement::signals {
namespace {

constexpr std::size_t long_run = 64;  // samples

}  // namespace

bool NormalisedRun::is_long() const {
  return samples() >= long_run;
}

double NormalisedRun::freedom_of_lowest(std::size_t count) const {
  // The upper half of the frequencies told the level.
  const std::size_t half = samples() / 2;
  if (residual->own_estimate && is_long()) return std::min(residual->freedom, static_cast<double>(samples() - half));
  return residual->freedom_below(static_cast<double>(count) / (2.0 * static_cast<double>(samples())));
}

NormalisedRun normalised(const ScaledResidual& residual) {
  NormalisedRun run;
  run.residual = &residual;
  const std::size_t n = residual.values.size();
  run.energies = signals::cosine_energies(residual.values);
  double high = 0.0;
  const std::size_t half = n / 2;
  for (std::size_t k = n - half; k < n; ++k) high += run.energies[k] / static_cast<double>(half);
  const double largest = residual.own_estimate ? largest_level_estimated : largest_level_known;
  if (run.is_long() && residual.bands.empty()) {
    run.noise_variance = std::min(high, largest * largest);
    if (!residual.own_estimate) run.noise_variance = std::max(run.noise_variance, 1.0);
  }
  // With a variance of zero (a model that reproduces the data to the last digit) anything would be structure.
  run.noise_variance = std::max(run.noise_variance, allowed_structure * allowed_structure);
  for (double& energy : run.energies) energy /= run.noise_variance;
  run.allowed_energy = allowed_structure * allowed_structure * static_cast<double>(n) / run.noise_variance;
  if (run.has_times()) run.interval = (residual.times.back() - residual.times.front()) / static_cast<double>(n - 1);
  return run;
}

std::string length_text(const NormalisedRun& run, std::size_t samples) {
  if (!run.has_times()) return fmt::format("{} samples", samples);
  const double seconds = run.interval * static_cast<double>(samples);
  return seconds < 1.0 ? fmt::format("{:.3g} ms", 1e3 * seconds) : fmt::format("{:.3g} s", seconds);
}

}  // namespace coilwright::measurement::signals
