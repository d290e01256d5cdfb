#include "coilwright/measurement/signals/whiteness_test.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "measurement/signals/line_tests.hpp"
#include "measurement/signals/normalised_run.hpp"
#include "measurement/signals/test_limits.hpp"

namespace coilwright::measurement::signals {
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

// Tests the energy at all wavelengths longer than 2, 4, 8, ... samples, of all runs pooled.
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

// Tests the same energies of each run alone.
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

constexpr std::size_t smallest_block = 8;  // samples

struct SampleBlock {
  const NormalisedRun* run{};
  std::size_t first{};
  std::size_t size{};
};

// Blocks inside windows, each overlapping the next by half.
std::vector<SampleBlock> blocks_of(std::span<const NormalisedRun> runs) {
  std::vector<SampleBlock> blocks;
  for (const NormalisedRun& run : runs) {
    if (!run.is_long()) continue;
    const std::vector<std::size_t>& starts = run.residual->starts;
    for (std::size_t w = 0; w < starts.size(); ++w) {
      const std::size_t end = w + 1 < starts.size() ? starts[w + 1] : run.samples();
      for (std::size_t size = smallest_block; 2 * size <= end - starts[w]; size *= 2)
        for (std::size_t first = starts[w]; first + size <= end; first += size / 2)
          blocks.push_back({&run, first, size});
    }
  }
  return blocks;
}

struct RunSums {
  std::vector<double> running_sums{};
  std::map<std::size_t, double> limits{};  // by the size of a block
};

// Tests the means of blocks of 8, 16, ... samples of each long run. A short event (an impact, a stick) disappears in
// sums over a run, but not in a mean over its own length.
void test_blocks(std::span<const NormalisedRun> runs, WorstTest& worst) {
  const std::vector<SampleBlock> blocks = blocks_of(runs);
  std::map<const NormalisedRun*, RunSums> sums_of;
  for (const SampleBlock& block : blocks) {
    auto [found, is_new] = sums_of.try_emplace(block.run);
    RunSums& of_run = found->second;
    if (is_new) {
      const std::vector<double>& values = block.run->residual->values;
      of_run.running_sums.assign(values.size() + 1, 0.0);
      std::partial_sum(values.begin(), values.end(), of_run.running_sums.begin() + 1);
    }
    const auto [limit, first_of_size] = of_run.limits.try_emplace(block.size);
    if (first_of_size)
      limit->second =
          energy_limit({.count = 1.0,
                        .degrees_of_freedom = block.run->residual->freedom_below(0.5 / static_cast<double>(block.size)),
                        .allowed_energy = block.run->allowed_energy},
                       false_alarms::of_blocks / static_cast<double>(blocks.size()));
    const double sum = of_run.running_sums[block.first + block.size] - of_run.running_sums[block.first];
    worst.consider(sum * sum / (static_cast<double>(block.size) * block.run->noise_variance), 1.0, limit->second, [&] {
      const std::string place = block.run->has_times()
                                    ? fmt::format("{:.4g} s", block.run->residual->times[block.first])
                                    : fmt::format("sample {}", block.first);
      return fmt::format("{}, {} from {}", block.run->residual->run, length_text(*block.run, block.size), place);
    });
  }
}

constexpr std::size_t shortest_tested_run = 4;  // samples

}  // namespace

WhitenessResult whiteness_test(std::span<const ScaledResidual> residuals, int fitted_parameters) {
  validate_residuals(residuals);
  if (fitted_parameters < 0)
    throw std::invalid_argument(fmt::format("fitted_parameters must be >= 0; got {}", fitted_parameters));
  std::vector<NormalisedRun> runs;
  double energy = 0.0;
  double samples = 0.0;
  for (const ScaledResidual& residual : residuals) {
    for (const double value : residual.values) energy += value * value;
    samples += static_cast<double>(residual.values.size());
    if (residual.values.size() >= shortest_tested_run) runs.push_back(normalised(residual));
  }
  WhitenessResult result;
  const double free = samples - fitted_parameters;
  if (samples > 0.0) result.level = std::sqrt(energy / (free >= 1.0 ? free : samples));

  WorstTest worst;
  test_pooled_bands(runs, worst);
  test_bands_of_each_run(runs, worst);
  const std::vector<LineSpectrum> spectra = line_spectra(runs);
  test_lines_of_each_run(spectra, worst);
  test_pooled_lines(spectra, worst);
  test_blocks(runs, worst);
  result.structure = worst.ratio();
  result.where = worst.where();
  return result;
}

}  // namespace coilwright::measurement::signals
