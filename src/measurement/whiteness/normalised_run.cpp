#include "measurement/whiteness/normalised_run.hpp"

#include <fmt/format.h>

#include "measurement/noise/spectrum.hpp"

namespace coilwright::measurement::whiteness {
namespace {

constexpr std::size_t long_run = 64;  // samples

}  // namespace

bool NormalisedRun::is_long() const {
  return samples() >= long_run;
}

double NormalisedRun::freedom_of_lowest(std::size_t count) const {
  return residual->freedom_below(static_cast<double>(count) / (2.0 * static_cast<double>(samples())));
}

NormalisedRun normalised(const ScaledResidual& residual) {
  NormalisedRun run;
  run.residual = &residual;
  const std::size_t n = residual.values.size();
  run.energies = noise::cosine_energies(residual.values);
  run.allowed_energy = allowed_structure * allowed_structure * static_cast<double>(n);
  if (run.has_times()) run.interval = (residual.times.back() - residual.times.front()) / static_cast<double>(n - 1);
  return run;
}

std::string length_text(const NormalisedRun& run, std::size_t samples) {
  if (!run.has_times()) return fmt::format("{} samples", samples);
  const double seconds = run.interval * static_cast<double>(samples);
  return seconds < 1.0 ? fmt::format("{:.3g} ms", 1e3 * seconds) : fmt::format("{:.3g} s", seconds);
}

}  // namespace coilwright::measurement::whiteness
