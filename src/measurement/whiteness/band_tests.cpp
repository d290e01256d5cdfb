#include "measurement/whiteness/band_tests.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

#include "measurement/whiteness/energy_limits.hpp"
#include "measurement/whiteness/false_alarms.hpp"

namespace coilwright::measurement::whiteness {
namespace {

// Number of coefficients whose wavelength is at least 2 `scale` samples: those that means over `scale` samples contain.
std::size_t coefficients(const NormalisedRun& run, std::size_t scale) {
  return std::max<std::size_t>(run.samples() / scale, 1);
}

double low_energy(const NormalisedRun& run, std::size_t count) {
  return std::accumulate(run.energies.begin(), run.energies.begin() + static_cast<std::ptrdiff_t>(count), 0.0);
}

std::vector<std::size_t> scales_of(std::size_t first, std::size_t samples) {
  std::vector<std::size_t> scales;
  for (std::size_t scale = first; scale <= samples; scale *= 2) scales.push_back(scale);
  return scales;
}

// All frequencies: the level of the residual itself is a test.
constexpr std::size_t finest_scale = 1;

}  // namespace

void test_pooled_bands(std::span<const NormalisedRun> runs, WorstTest& worst) {
  std::size_t longest = 0;
  const NormalisedRun* named = nullptr;
  for (const NormalisedRun& run : runs)
    if (run.is_long() && run.samples() > longest) {
      longest = run.samples();
      named = &run;
    }
  if (named == nullptr) return;
  const std::vector<std::size_t> scales = scales_of(finest_scale, longest);
  for (const std::size_t scale : scales) {
    PooledEnergy pooled;
    for (const NormalisedRun& run : runs) {
      if (!run.is_long() && run.residual->own_estimate) continue;
      const std::size_t count = coefficients(run, scale);
      pooled.add(low_energy(run, count), {.count = static_cast<double>(count),
                                          .degrees_of_freedom = run.freedom_of_lowest(count),
                                          .allowed_energy = run.allowed_energy});
    }
    worst.consider(pooled.energy(), pooled.expected(),
                   pooled.limit(false_alarms::of_pooled_bands / static_cast<double>(scales.size())),
                   [&] { return fmt::format("all runs, structure over {} and longer", length_text(*named, scale)); });
  }
}

void test_bands_of_each_run(std::span<const NormalisedRun> runs, WorstTest& worst) {
  std::size_t tests = 0;
  for (const NormalisedRun& run : runs) tests += scales_of(finest_scale, run.samples()).size();
  for (const NormalisedRun& run : runs)
    for (const std::size_t scale : scales_of(finest_scale, run.samples())) {
      const std::size_t count = coefficients(run, scale);
      const double limit = energy_limit({.count = static_cast<double>(count),
                                         .degrees_of_freedom = run.freedom_of_lowest(count),
                                         .allowed_energy = run.allowed_energy},
                                        false_alarms::of_bands / static_cast<double>(tests));
      worst.consider(low_energy(run, count), static_cast<double>(count), limit, [&] {
        return fmt::format("{}, structure over {} and longer", run.residual->run, length_text(run, scale));
      });
    }
}

}  // namespace coilwright::measurement::whiteness
