#include "measurement/localise/spectral_line.hpp"

#include <algorithm>
#include <boost/math/distributions/gamma.hpp>
#include <cmath>
#include <numbers>

#include "measurement/signals/spectrum.hpp"

namespace coilwright::measurement::localise {
namespace {

struct Spectrum {
  std::vector<double> frequency;  // Hz
  std::vector<double> power;
  std::vector<double> ratio;  // of the power to the mean of its surroundings, which follows from their median
};

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

Spectrum spectrum_of(const EvenSeries& series) {
  const signals::Periodogram lines = signals::periodogram(series.values);
  const double step = 1.0 / (series.interval * static_cast<double>(lines.size));
  const auto resolved = lines.size / series.values.size();  // bins of the padded transform per resolved frequency
  Spectrum result;
  // At least two cycles per series.
  const std::size_t first = 2 * resolved + 1;
  for (std::size_t k = 0; k < lines.power.size(); ++k) {
    result.frequency.push_back(step * static_cast<double>(k));
    result.power.push_back(lines.power[k]);
    result.ratio.push_back(0.0);
  }
  for (std::size_t k = first; k < lines.power.size(); ++k) {
    const std::size_t gap = 2 * resolved;  // width of a line
    const std::size_t reach = std::max<std::size_t>(k / 3, 6 * resolved);
    const std::size_t low = k > reach + gap ? k - reach - gap : 1;
    const std::size_t high = std::min(k + reach + gap, lines.power.size() - 1);
    std::vector<double> around;
    for (std::size_t i = low; i <= high; ++i)
      if (i + gap < k || i > k + gap) around.push_back(lines.power[i]);
    if (around.empty()) continue;
    const double mean = median(std::move(around)) / std::numbers::ln2;  // of an exponential distribution
    if (mean > 0.0) result.ratio[k] = lines.power[k] / mean;
  }
  return result;
}

}  // namespace

std::optional<double> strongest_spectral_line(std::span<const EvenSeries> series) {
  std::vector<Spectrum> spectra;
  double longest = 0.0;
  double fastest = 0.0;
  for (const EvenSeries& one : series) {
    if (one.values.size() < 64) continue;
    spectra.push_back(spectrum_of(one));
    longest = std::max(longest, one.interval * static_cast<double>(one.values.size()));
    fastest = std::max(fastest, 0.5 / one.interval);
  }
  if (spectra.empty()) return std::nullopt;

  const double step = 0.25 / longest;
  const auto count = static_cast<std::size_t>(fastest / step);
  constexpr double largest_ratio = 50.0;
  constexpr double chance = 0.01;
  std::optional<double> best;
  double best_excess = 1.0;
  double best_power = 0.0;
  std::vector<double> limits(spectra.size() + 1, 0.0);
  for (std::size_t members = 1; members <= spectra.size(); ++members) {
    const boost::math::gamma_distribution<double> distribution(static_cast<double>(members), 1.0);
    limits[members] = boost::math::quantile(boost::math::complement(distribution, chance / static_cast<double>(count)));
  }
  for (std::size_t k = 1; k <= count; ++k) {
    const double frequency = step * static_cast<double>(k);
    double sum = 0.0;
    double power = 0.0;
    std::size_t members = 0;
    for (const Spectrum& spectrum : spectra) {
      const auto nearest = static_cast<std::size_t>(std::lround(frequency / spectrum.frequency[1]));
      if (nearest >= spectrum.ratio.size() || spectrum.ratio[nearest] == 0.0) continue;
      sum += std::min(spectrum.ratio[nearest], largest_ratio);
      power += spectrum.power[nearest];
      ++members;
    }
    if (members == 0) continue;
    const double excess = sum / limits[members];
    // Of lines with equal excess the more powerful one.
    if (excess > best_excess || (best && excess == best_excess && power > best_power)) {
      best = frequency;
      best_excess = excess;
      best_power = power;
    }
  }
  return best;
}

}  // namespace coilwright::measurement::localise
