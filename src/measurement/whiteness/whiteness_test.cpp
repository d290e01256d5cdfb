#include "coilwright/measurement/whiteness/whiteness_test.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/gamma.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <stdexcept>

#include "measurement/noise/spectrum.hpp"

namespace coilwright::measurement::whiteness {
namespace {

// White noise may fail in one set out of two hundred: shared out among the kinds of tests, then by Bonferroni.
constexpr double chance_of_bands_together = 0.005;
constexpr double chance_of_bands_alone = 0.0015;
constexpr double chance_of_lines_together = 0.001;
constexpr double chance_of_lines_alone = 0.001;
constexpr double chance_of_blocks = 0.001;

// Discretisation, interpolation, a clock's jitter: what no effect explains and nobody would miss. In units of the
// noise.
constexpr double allowed_structure = 0.03;

// A run of fewer samples has too few high frequencies to be judged by them alone.
constexpr std::size_t long_run = 64;
constexpr std::size_t shortest_run = 4;
constexpr double certain = std::numeric_limits<double>::infinity();

struct Judged {
  const ScaledResidual* residual{};
  std::vector<double> energies{};  // of the cosine transform, over the run's own level
  double level{};                  // variance that counts as noise
  double known{};                  // degrees of freedom behind it
  double allowed{};                // energy of the structure that is allowed
  double interval = 1.0;           // s between samples; 1 on a bench

  [[nodiscard]] std::size_t samples() const { return residual->values.size(); }
  [[nodiscard]] bool is_long() const { return samples() >= long_run; }
  [[nodiscard]] bool timed() const { return !residual->times.empty(); }
};

Judged judged(const ScaledResidual& residual) {
  Judged run;
  run.residual = &residual;
  const std::size_t n = residual.values.size();
  run.energies = noise::cosine_energies(residual.values);
  const std::size_t half = n - n / 2;
  double high = 0.0;
  for (std::size_t k = half; k < n; ++k) high += run.energies[k];
  run.level = high / static_cast<double>(n - half);
  run.known = static_cast<double>(n - half);
  if (residual.sigma_given || !run.is_long()) run.level = std::max(run.level, 1.0);
  if (residual.sigma_given && !run.is_long()) run.known = certain;
  // A level of nothing (a model that meets the data to the last digit) would make anything a structure.
  run.level = std::max(run.level, allowed_structure * allowed_structure);
  for (double& energy : run.energies) energy /= run.level;
  run.allowed = allowed_structure * allowed_structure * static_cast<double>(n) / run.level;
  if (run.timed()) run.interval = (residual.times.back() - residual.times.front()) / static_cast<double>(n - 1);
  return run;
}

// A sum of `count` squares over an estimated variance, which noise exceeds with `chance`; `allowed` is the mean energy
// of structure that may be there besides (Patnaik's approximation of the law with an offset).
double limit_alone(double count, double known, double allowed, double chance) {
  const double mean = count + allowed;
  const double freedom = mean * mean / (count + 2.0 * allowed);
  if (std::isinf(known)) {
    const boost::math::gamma_distribution<double> law(0.5 * freedom, 2.0);
    return mean / freedom * boost::math::quantile(boost::math::complement(law, chance));
  }
  const boost::math::fisher_f_distribution<double> law(freedom, known);
  return mean * boost::math::quantile(boost::math::complement(law, chance));
}

// Several of them added up: the gamma law of the same mean and variance.
class Together {
 public:
  void add(double energy, double count, double known, double allowed) {
    energy_ += energy;
    count_ += count;
    allowed_ += allowed;
    if (std::isinf(known)) {
      mean_ += count;
      variance_ += 2.0 * count;
    } else {
      // Moments of Fisher's F; runs of at least 64 samples have known >= 32.
      mean_ += count * known / (known - 2.0);
      variance_ +=
          2.0 * count * known * known * (count + known - 2.0) / ((known - 2.0) * (known - 2.0) * (known - 4.0));
    }
  }
  [[nodiscard]] double energy() const { return energy_; }
  [[nodiscard]] double expected() const { return count_; }
  [[nodiscard]] double limit(double chance) const {
    const double mean = mean_ + allowed_;
    const double variance = variance_ + 4.0 * allowed_;
    const boost::math::gamma_distribution<double> law(mean * mean / variance, variance / mean);
    return boost::math::quantile(boost::math::complement(law, chance));
  }

 private:
  double energy_{}, count_{}, allowed_{}, mean_{}, variance_{};
};

class Worst {
 public:
  template <typename Where>
  void meet(double energy, double expected, double limit, Where&& where) {
    const double excess = (energy - expected) / (limit - expected);
    if (excess <= structure_ && !where_.empty()) return;
    structure_ = std::max(excess, 0.0);
    where_ = where();
  }
  [[nodiscard]] double structure() const { return structure_; }
  [[nodiscard]] const std::string& where() const { return where_; }

 private:
  double structure_{};
  std::string where_;
};

std::string duration(const Judged& run, std::size_t samples) {
  if (!run.timed()) return fmt::format("{} samples", samples);
  const double seconds = run.interval * static_cast<double>(samples);
  return seconds < 1.0 ? fmt::format("{:.3g} ms", 1e3 * seconds) : fmt::format("{:.3g} s", seconds);
}

// Coefficients whose wavelength is at least 2 `scale` samples: what means over `scale` samples see.
std::size_t coefficients(const Judged& run, std::size_t scale) {
  return std::max<std::size_t>(run.samples() / scale, 1);
}

double low_energy(const Judged& run, std::size_t count) {
  return std::accumulate(run.energies.begin(), run.energies.begin() + static_cast<std::ptrdiff_t>(count), 0.0);
}

std::vector<std::size_t> scales_of(std::size_t first, std::size_t samples) {
  std::vector<std::size_t> scales;
  for (std::size_t scale = first; scale <= samples; scale *= 2) scales.push_back(scale);
  return scales;
}

constexpr std::size_t finest_scale(bool is_long) {
  // The upper half of the frequencies is the measure; on a long run the next octave down is left to the lines.
  return is_long ? 4 : 2;
}

void test_bands_together(const std::vector<Judged>& runs, Worst& worst) {
  std::size_t longest = 0;
  const Judged* named = nullptr;
  for (const Judged& run : runs)
    if (run.is_long() && run.samples() > longest) {
      longest = run.samples();
      named = &run;
    }
  if (named == nullptr) return;
  const std::vector<std::size_t> scales = scales_of(finest_scale(true), longest);
  for (const std::size_t scale : scales) {
    Together together;
    for (const Judged& run : runs) {
      if (!run.is_long() && !std::isinf(run.known)) continue;
      const std::size_t count = coefficients(run, scale);
      together.add(low_energy(run, count), static_cast<double>(count), run.known, run.allowed);
    }
    worst.meet(together.energy(), together.expected(),
               together.limit(chance_of_bands_together / static_cast<double>(scales.size())),
               [&] { return fmt::format("all runs, structure over {} and longer", duration(*named, scale)); });
  }
}

void test_bands_alone(const std::vector<Judged>& runs, Worst& worst) {
  std::size_t tests = 0;
  for (const Judged& run : runs) tests += scales_of(finest_scale(run.is_long()), run.samples()).size();
  for (const Judged& run : runs)
    for (const std::size_t scale : scales_of(finest_scale(run.is_long()), run.samples())) {
      const std::size_t count = coefficients(run, scale);
      const double limit = limit_alone(static_cast<double>(count), run.known, run.allowed,
                                       chance_of_bands_alone / static_cast<double>(tests));
      worst.meet(low_energy(run, count), static_cast<double>(count), limit, [&] {
        return fmt::format("{}, structure over {} and longer", run.residual->run, duration(run, scale));
      });
    }
}

struct Lines {
  const Judged* run{};
  noise::Periodogram spectrum;  // over the run's own level
  std::size_t first{};          // slower than one and a half turns a run is left to the bands
  std::size_t last{};           // and next to the Nyquist frequency the law is another
};

std::vector<Lines> lines_of(const std::vector<Judged>& runs) {
  std::vector<Lines> all;
  for (const Judged& run : runs) {
    if (!run.is_long()) continue;
    Lines lines{.run = &run, .spectrum = noise::periodogram(run.residual->values), .first = 0, .last = 0};
    for (double& power : lines.spectrum.power) power /= run.level;
    lines.first = (3 * lines.spectrum.size + 2 * run.samples() - 1) / (2 * run.samples());
    lines.last = lines.spectrum.size / 2 - lines.first;
    all.push_back(std::move(lines));
  }
  return all;
}

std::string frequency_text(const Judged& run, double turns_per_sample) {
  if (!run.timed()) return fmt::format("{:.3g} samples a turn", 1.0 / turns_per_sample);
  return fmt::format("{:.4g} Hz", turns_per_sample / run.interval);
}

void test_lines_alone(const std::vector<Lines>& all, Worst& worst) {
  std::size_t tests = 0;
  for (const Lines& lines : all) tests += lines.last - lines.first + 1;
  for (const Lines& lines : all) {
    const auto& power = lines.spectrum.power;
    const auto peak = std::max_element(power.begin() + static_cast<std::ptrdiff_t>(lines.first),
                                       power.begin() + static_cast<std::ptrdiff_t>(lines.last) + 1);
    const double limit =
        limit_alone(2.0, lines.run->known, lines.run->allowed, chance_of_lines_alone / static_cast<double>(tests));
    worst.meet(2.0 * *peak, 2.0, limit, [&] {
      const double turns = static_cast<double>(peak - power.begin()) / static_cast<double>(lines.spectrum.size);
      return fmt::format("{}, line at {}", lines.run->residual->run, frequency_text(*lines.run, turns));
    });
  }
}

// The same frequency in several runs: periodograms added up on a grid of frequencies that the longest run resolves.
void test_lines_together(const std::vector<Lines>& all, Worst& worst) {
  double longest = 0.0;
  double fastest = 0.0;
  std::size_t timed = 0;
  for (const Lines& lines : all)
    if (lines.run->timed()) {
      longest = std::max(longest, lines.run->interval * static_cast<double>(lines.run->samples()));
      fastest = std::max(fastest, 0.5 / lines.run->interval);
      ++timed;
    }
  if (timed < 2) return;
  const double step = 0.5 / longest;
  const auto tests = static_cast<std::size_t>(fastest / step);
  std::map<std::vector<bool>, double> limits;
  for (std::size_t k = 1; k <= tests; ++k) {
    const double frequency = step * static_cast<double>(k);
    Together together;
    std::vector<bool> who;
    for (const Lines& lines : all) {
      const double place = frequency * lines.run->interval * static_cast<double>(lines.spectrum.size);
      const auto nearest = static_cast<std::size_t>(place + 0.5);
      const bool there = lines.run->timed() && nearest >= lines.first && nearest <= lines.last;
      who.push_back(there);
      if (there) together.add(2.0 * lines.spectrum.power[nearest], 2.0, lines.run->known, lines.run->allowed);
    }
    if (std::count(who.begin(), who.end(), true) < 2) continue;
    auto known = limits.find(who);
    if (known == limits.end())
      known = limits.emplace(who, together.limit(chance_of_lines_together / static_cast<double>(tests))).first;
    worst.meet(together.energy(), together.expected(), known->second,
               [&] { return fmt::format("all runs, line at {:.4g} Hz", frequency); });
  }
}

// Something short in one place (an impact, a stick) is lost in sums over a run, and stands out in a mean over it.
struct Block {
  const Judged* run{};
  std::size_t first{};
  std::size_t size{};
};

std::vector<Block> blocks_of(const std::vector<Judged>& runs) {
  constexpr std::size_t smallest = 8;
  std::vector<Block> blocks;
  for (const Judged& run : runs) {
    if (!run.is_long()) continue;
    const std::vector<std::size_t>& starts = run.residual->starts;
    for (std::size_t w = 0; w < starts.size(); ++w) {
      const std::size_t end = w + 1 < starts.size() ? starts[w + 1] : run.samples();
      for (std::size_t size = smallest; 2 * size <= end - starts[w]; size *= 2)
        for (std::size_t first = starts[w]; first + size <= end; first += size / 2)
          blocks.push_back({&run, first, size});
    }
  }
  return blocks;
}

void test_blocks(const std::vector<Judged>& runs, Worst& worst) {
  const std::vector<Block> blocks = blocks_of(runs);
  std::map<const Judged*, std::pair<std::vector<double>, double>> known;  // running sums, limit
  for (const Block& block : blocks) {
    auto [found, is_new] = known.try_emplace(block.run);
    if (is_new) {
      const std::vector<double>& values = block.run->residual->values;
      std::vector<double> sums(values.size() + 1, 0.0);
      std::partial_sum(values.begin(), values.end(), sums.begin() + 1);
      found->second = {std::move(sums), limit_alone(1.0, block.run->known, block.run->allowed,
                                                    chance_of_blocks / static_cast<double>(blocks.size()))};
    }
    const std::vector<double>& sums = found->second.first;
    const double sum = sums[block.first + block.size] - sums[block.first];
    worst.meet(sum * sum / (static_cast<double>(block.size) * block.run->level), 1.0, found->second.second, [&] {
      const std::string place = block.run->timed() ? fmt::format("{:.4g} s", block.run->residual->times[block.first])
                                                   : fmt::format("sample {}", block.first);
      return fmt::format("{}, {} from {}", block.run->residual->run, duration(*block.run, block.size), place);
    });
  }
}

}  // namespace

Adequacy adequacy_of(std::span<const ScaledResidual> residuals, int fitted_parameters) {
  check(residuals);
  if (fitted_parameters < 0)
    throw std::invalid_argument(fmt::format("fitted_parameters must be >= 0; got {}", fitted_parameters));
  std::vector<Judged> runs;
  double energy = 0.0;
  double samples = 0.0;
  for (const ScaledResidual& residual : residuals) {
    for (const double value : residual.values) energy += value * value;
    samples += static_cast<double>(residual.values.size());
    if (residual.values.size() >= shortest_run) runs.push_back(judged(residual));
  }
  Adequacy adequacy;
  const double free = samples - fitted_parameters;
  if (samples > 0.0) adequacy.level = std::sqrt(energy / (free >= 1.0 ? free : samples));

  Worst worst;
  test_bands_together(runs, worst);
  test_bands_alone(runs, worst);
  const std::vector<Lines> lines = lines_of(runs);
  test_lines_alone(lines, worst);
  test_lines_together(lines, worst);
  test_blocks(runs, worst);
  adequacy.structure = worst.structure();
  adequacy.where = worst.where();
  return adequacy;
}

}  // namespace coilwright::measurement::whiteness
