#include "measurement/whiteness/normalised_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "measurement/noise/spectrum.hpp"

namespace coilwright::measurement::whiteness {
namespace {

constexpr std::size_t long_run = 64;  // samples

}  // namespace

bool NormalisedRun::is_long() const {
  return samples() >= long_run;
}

NormalisedRun normalised(const ScaledResidual& residual) {
  NormalisedRun run;
  run.residual = &residual;
  const std::size_t n = residual.values.size();
  run.energies = noise::cosine_energies(residual.values);
  const std::size_t half = n - n / 2;
  double high = 0.0;
  for (std::size_t k = half; k < n; ++k) high += run.energies[k];
  run.noise_variance = high / static_cast<double>(n - half);
  run.degrees_of_freedom = static_cast<double>(n - half);
  if (residual.sigma_given || !run.is_long()) run.noise_variance = std::max(run.noise_variance, 1.0);
  if (residual.sigma_given && !run.is_long()) run.degrees_of_freedom = std::numeric_limits<double>::infinity();
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

}  // namespace coilwright::measurement::whiteness
