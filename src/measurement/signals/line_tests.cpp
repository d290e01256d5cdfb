#include "measurement/signals/line_tests.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "measurement/signals/test_limits.hpp"

namespace coilwright::measurement::signals {
namespace {

// The two squares of a spectral line: its cosine and its sine.
SumOfSquares line_of(const NormalisedRun& run, double cycles_per_sample) {
  return {.count = 2.0,
          .degrees_of_freedom = run.residual->freedom_at(cycles_per_sample),
          .allowed_energy = run.allowed_energy};
}

std::string frequency_text(const NormalisedRun& run, double cycles_per_sample) {
  if (!run.has_times()) return fmt::format("{:.3g} samples a turn", 1.0 / cycles_per_sample);
  return fmt::format("{:.4g} Hz", cycles_per_sample / run.interval);
}

}  // namespace

std::vector<LineSpectrum> line_spectra(std::span<const NormalisedRun> runs) {
  std::vector<LineSpectrum> all;
  for (const NormalisedRun& run : runs) {
    if (!run.is_long()) continue;
    LineSpectrum lines{.run = &run, .spectrum = signals::periodogram(run.residual->values), .first = 0, .last = 0};
    for (double& power : lines.spectrum.power) power /= run.noise_variance;
    lines.first = (3 * lines.spectrum.size + 2 * run.samples() - 1) / (2 * run.samples());
    lines.last = lines.spectrum.size / 2 - lines.first;
    all.push_back(std::move(lines));
  }
  return all;
}

void test_lines_of_each_run(std::span<const LineSpectrum> spectra, WorstTest& worst) {
  std::size_t tests = 0;
  for (const LineSpectrum& lines : spectra) tests += lines.last - lines.first + 1;
  for (const LineSpectrum& lines : spectra) {
    std::map<double, double> limits;  // by the degrees of freedom of the noise's level
    for (std::size_t k = lines.first; k <= lines.last; ++k) {
      const double cycles = static_cast<double>(k) / static_cast<double>(lines.spectrum.size);
      const SumOfSquares line = line_of(*lines.run, cycles);
      const auto [limit, is_new] = limits.try_emplace(line.degrees_of_freedom);
      if (is_new) limit->second = energy_limit(line, false_alarms::of_lines / static_cast<double>(tests));
      worst.consider(2.0 * lines.spectrum.power[k], 2.0, limit->second, [&] {
        return fmt::format("{}, line at {}", lines.run->residual->run, frequency_text(*lines.run, cycles));
      });
    }
  }
}

void test_pooled_lines(std::span<const LineSpectrum> spectra, WorstTest& worst) {
  double longest = 0.0;
  double fastest = 0.0;
  std::size_t with_times = 0;
  for (const LineSpectrum& lines : spectra)
    if (lines.run->has_times()) {
      longest = std::max(longest, lines.run->interval * static_cast<double>(lines.run->samples()));
      fastest = std::max(fastest, 0.5 / lines.run->interval);
      ++with_times;
    }
  if (with_times < 2) return;
  const double step = 0.5 / longest;
  const auto tests = static_cast<std::size_t>(fastest / step);
  std::map<std::vector<bool>, double> limits;  // by the runs that have the frequency
  for (std::size_t k = 1; k <= tests; ++k) {
    const double frequency = step * static_cast<double>(k);
    PooledEnergy pooled;
    std::vector<bool> members;
    for (const LineSpectrum& lines : spectra) {
      const double place = frequency * lines.run->interval * static_cast<double>(lines.spectrum.size);
      const auto nearest = static_cast<std::size_t>(std::lround(place));
      const bool tested = lines.run->has_times() && nearest >= lines.first && nearest <= lines.last;
      members.push_back(tested);
      if (tested) pooled.add(2.0 * lines.spectrum.power[nearest], line_of(*lines.run, frequency * lines.run->interval));
    }
    if (std::count(members.begin(), members.end(), true) < 2) continue;
    auto limit = limits.find(members);
    const bool same_everywhere =
        std::ranges::all_of(spectra, [](const LineSpectrum& lines) { return lines.run->residual->bands.empty(); });
    if (limit == limits.end() || !same_everywhere)
      limit = limits.insert_or_assign(members, pooled.limit(false_alarms::of_pooled_lines / static_cast<double>(tests)))
                  .first;
    worst.consider(pooled.energy(), pooled.expected(), limit->second,
                   [&] { return fmt::format("all runs, line at {:.4g} Hz", frequency); });
  }
}

}  // namespace coilwright::measurement::signals
