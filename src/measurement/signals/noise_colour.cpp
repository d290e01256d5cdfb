#include "measurement/signals/noise_colour.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <complex>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <optional>
#include <span>
#include <stdexcept>

#include "coilwright/algebra/least_squares.hpp"
#include "measurement/signals/spectrum.hpp"

namespace coilwright::measurement::signals {
namespace {

constexpr double pi = std::numbers::pi;
constexpr std::size_t fewest_samples = 32;
constexpr double fewest_coefficients = 16.0;  // in a band
const double band_ratio = std::exp2(0.25);    // upper over lower end of a band
constexpr std::size_t most_lines = 4;
constexpr double chance_of_a_line = 1e-3;  // in a record of white noise
constexpr double chance_of_colour = 0.01;
constexpr std::size_t low_coefficients = 96;  // from which the growth towards low frequencies is taken
constexpr double steepest = 2.0;              // exponent: a random walk
// Of the lowest frequency that the record shows: below it the density is taken as level.
constexpr double level_below = 0.25;

using Series = std::vector<double>;

Series without_mean(std::span<const double> values) {
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  Series out(values.begin(), values.end());
  for (double& value : out) value -= mean;
  return out;
}

// |sum of v_j exp(-2 pi i f j)|^2 at f cycles per sample.
double power_at(const Series& values, double frequency) {
  const std::complex<double> turn = std::polar(1.0, -2.0 * pi * frequency);
  std::complex<double> sum = 0.0;
  for (std::size_t j = values.size(); j-- > 0;) sum = sum * turn + values[j];
  return std::norm(sum);
}

// Cosine and sine of a line, and what is left without it.
struct FittedLine {
  double amplitude{};
  Series rest{};
};

FittedLine without_line(const Series& values, double frequency) {
  const auto n = static_cast<Eigen::Index>(values.size());
  Eigen::MatrixXd basis(n, 2);
  for (Eigen::Index j = 0; j < n; ++j) {
    const double phase = 2.0 * pi * frequency * static_cast<double>(j);
    basis.row(j) << std::cos(phase), std::sin(phase);
  }
  const Eigen::Map<const Eigen::VectorXd> series(values.data(), n);
  const Eigen::Vector2d fitted = algebra::least_squares(basis, series);
  FittedLine out{.amplitude = fitted.norm(), .rest = Series(values.size())};
  Eigen::Map<Eigen::VectorXd>(out.rest.data(), n) = series - basis * fitted;
  return out;
}

// A periodogram's ordinates and powers as logarithms; nothing of the ordinate at 0.
struct LogarithmicSpectrum {
  std::vector<double> places{}, values{};

  explicit LogarithmicSpectrum(const std::vector<double>& power) : places(power.size()), values(power.size()) {
    for (std::size_t i = 1; i < power.size(); ++i) {
      places[i] = std::log(static_cast<double>(i));
      values[i] = std::log(std::max(power[i], 1e-300));
    }
  }
};

// What a periodogram has at ordinate `at` without a line there, by a power law through its surroundings. The logarithm
// of an exponential distribution lies Euler's constant below that of its mean, and a line among them hardly moves it.
double surroundings_of(const LogarithmicSpectrum& spectrum, std::size_t at, std::size_t reach, std::size_t gap,
                       std::size_t last) {
  const std::size_t from = at > reach ? at - reach : 1;
  const std::size_t to = std::min(at + reach, last);
  double count = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  for (std::size_t i = from; i <= to; ++i) {
    if (i + gap >= at && i <= at + gap) continue;
    const double place = spectrum.places[i] - spectrum.places[at];
    const double value = spectrum.values[i];
    count += 1.0;
    x += place;
    y += value;
    xx += place * place;
    xy += place * value;
  }
  const double determinant = count * xx - x * x;
  if (determinant <= 0.0) return 0.0;
  return std::exp((xx * y - x * xy) / determinant + std::numbers::egamma);
}

// The strongest line that stands out of its surroundings, cycles per sample. The surroundings are a third of the
// frequency to both sides, at least 24 ordinates.
std::optional<double> strongest_line(const Series& values) {
  const Periodogram spectrum = periodogram(values);
  const std::size_t per_ordinate = std::max<std::size_t>(1, spectrum.size / values.size());
  const std::size_t first = 3 * per_ordinate;
  const std::size_t last = spectrum.size / 2;
  const auto ordinates = static_cast<double>(last);  // of the padded transform, all of which are searched
  const double limit = std::log(ordinates / chance_of_a_line);
  const LogarithmicSpectrum logarithms(spectrum.power);
  double best = 1.0;
  std::optional<std::size_t> found;
  for (std::size_t k = first; k + first < last; ++k) {
    const std::size_t reach = std::max<std::size_t>(k / 3, 24 * per_ordinate);
    if (spectrum.power[k] < spectrum.power[k - 1] || spectrum.power[k] < spectrum.power[k + 1]) continue;
    const double around = surroundings_of(logarithms, k, reach, 2 * per_ordinate, last - 1);
    if (around <= 0.0) continue;
    const double excess = spectrum.power[k] / (around * limit);
    if (excess > best) {
      best = excess;
      found = k;
    }
  }
  if (!found) return std::nullopt;
  const double step = 1.0 / static_cast<double>(spectrum.size);
  const double centre = static_cast<double>(*found) * step;
  std::uintmax_t steps = 60;
  return boost::math::tools::brent_find_minima([&](double f) { return -power_at(values, f); }, centre - step,
                                               centre + step, 40, steps)
      .first;
}

struct Coefficient {
  double frequency, energy;  // Hz; over the variance
};

// The cosine coefficients of all pieces, the lowest frequency first.
std::vector<Coefficient> coefficients_of(const std::vector<Series>& pieces, double interval, double variance) {
  // Coefficient k of n has the frequency k / (2 n) cycles per sample; k = 0 is the mean, which is gone.
  std::vector<Coefficient> all;
  for (const Series& piece : pieces) {
    const std::vector<double> energies = cosine_energies(piece);
    for (std::size_t k = 1; k < energies.size(); ++k)
      all.push_back(
          {static_cast<double>(k) / (2.0 * static_cast<double>(piece.size()) * interval), energies[k] / variance});
  }
  std::ranges::stable_sort(all, {}, &Coefficient::frequency);
  return all;
}

std::vector<NoiseColour::Band> bands_of(const std::vector<Coefficient>& all, double nyquist) {
  std::vector<NoiseColour::Band> bands;
  NoiseColour::Band band;
  double energy = 0.0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    energy += all[i].energy;
    band.freedom += 1.0;
    const bool wide = i + 1 < all.size() && all[i + 1].frequency >= band_ratio * std::max(band.from, 1e-300);
    const bool enough_left = static_cast<double>(all.size() - i - 1) >= fewest_coefficients;
    if (band.freedom < fewest_coefficients || !wide || !enough_left) continue;
    band.to = 0.5 * (all[i].frequency + all[i + 1].frequency);
    band.density = energy / band.freedom;
    bands.push_back(band);
    band = {.from = band.to};
    energy = 0.0;
  }
  band.to = nyquist;
  band.density = energy / band.freedom;
  bands.push_back(band);
  return bands;
}

// The power law by which the lowest coefficients grow towards low frequencies, by Whittle's likelihood (Ark. Mat. 2,
// 423, 1953): energies are independent, each its density times chi-square of one degree of freedom. Nothing where one
// level does as well. One level for a whole band would be right on its mean and wrong where it matters: what is
// constant, or slow, stands against the lowest frequencies alone.
std::optional<NoiseColour::LowEnd> low_end_of(const std::vector<Coefficient>& all, const NoiseColour::Band& lowest) {
  const std::span low = std::span(all).first(std::min(all.size(), low_coefficients));
  const auto count = static_cast<double>(low.size());
  const auto level_at_end = [&](double exponent) {
    double sum = 0.0;
    for (const Coefficient& each : low) sum += each.energy * std::pow(each.frequency / lowest.to, exponent);
    return sum / count;
  };
  double logarithms = 0.0;
  for (const Coefficient& each : low) logarithms += std::log(each.frequency / lowest.to);
  // Minus twice the logarithm of the likelihood, at the best level.
  const auto deviance = [&](double exponent) {
    return count * std::log(level_at_end(exponent)) - exponent * logarithms;
  };
  if (!(level_at_end(0.0) > 0.0)) return std::nullopt;
  std::uintmax_t steps = 60;
  const auto [exponent, least] = boost::math::tools::brent_find_minima(deviance, 0.0, steepest, 30, steps);
  const boost::math::chi_squared_distribution<double> one(1.0);
  if (deviance(0.0) - least <= boost::math::quantile(boost::math::complement(one, chance_of_colour)))
    return std::nullopt;
  return NoiseColour::LowEnd{.from = level_below * all.front().frequency,
                             .to = lowest.to,
                             .exponent = exponent,
                             .density = level_at_end(exponent)};
}

// Whether the energies of the bands agree with one level: each is its density times chi-square of its freedom.
bool agree_with_white(const std::vector<NoiseColour::Band>& bands) {
  if (bands.size() < 2) return true;
  // Bartlett's test of equal variances (Proc. R. Soc. A 160, 268, 1937).
  double freedom = 0.0;
  double energy = 0.0;
  double inverse = 0.0;
  double logarithms = 0.0;
  for (const NoiseColour::Band& band : bands) {
    freedom += band.freedom;
    energy += band.freedom * band.density;
    inverse += 1.0 / band.freedom;
    logarithms += band.freedom * std::log(std::max(band.density, 1e-300));
  }
  const double correction = 1.0 + (inverse - 1.0 / freedom) / (3.0 * (static_cast<double>(bands.size()) - 1.0));
  const double sum = (freedom * std::log(energy / freedom) - logarithms) / correction;
  const boost::math::chi_squared_distribution<double> distribution(static_cast<double>(bands.size() - 1));
  return sum <= boost::math::quantile(boost::math::complement(distribution, chance_of_colour));
}

}  // namespace

double NoiseColour::density_at(double frequency) const {
  const auto middle = [](const Band& band) { return band.from > 0.0 ? std::sqrt(band.from * band.to) : 0.5 * band.to; };
  if (low_end && frequency <= low_end->to)
    return low_end->density * std::pow(std::max(frequency, low_end->from) / low_end->to, -low_end->exponent);
  if (frequency <= middle(bands.front())) return bands.front().density;
  for (std::size_t i = 1; i < bands.size(); ++i) {
    const double right = middle(bands[i]);
    if (frequency > right) continue;
    const bool from_low_end = low_end && i == 1;
    const double left = from_low_end ? low_end->to : middle(bands[i - 1]);
    const double there = from_low_end ? low_end->density : bands[i - 1].density;
    const double share = std::log(frequency / left) / std::log(right / left);
    return std::exp((1.0 - share) * std::log(there) + share * std::log(bands[i].density));
  }
  return bands.back().density;
}

NoiseColour colour_of(std::span<const StillPiece> pieces) {
  std::size_t longest = 0;
  for (std::size_t i = 1; i < pieces.size(); ++i)
    if (pieces[i].values.size() > pieces[longest].values.size()) longest = i;
  if (pieces.empty() || pieces[longest].values.size() < fewest_samples)
    throw std::invalid_argument(fmt::format("a record of the noise needs at least {} samples; got {}", fewest_samples,
                                            pieces.empty() ? 0 : pieces[longest].values.size()));
  const double interval = pieces[longest].interval;
  std::vector<Series> series;
  for (const StillPiece& piece : pieces)
    if (piece.values.size() > 1) series.push_back(without_mean(piece.values));
  NoiseColour out;
  // Lines are found in the longest piece, and taken out of all.
  const auto main = std::ranges::max_element(series, {}, &Series::size);
  while (out.lines.size() < most_lines) {
    const auto frequency = strongest_line(*main);
    if (!frequency) break;
    out.lines.push_back({.frequency = *frequency / interval, .amplitude = without_line(*main, *frequency).amplitude});
    for (Series& piece : series)
      if (piece.size() > 8) piece = without_line(piece, *frequency).rest;
  }
  double energy = 0.0;
  for (const Series& piece : series) {
    energy += std::inner_product(piece.begin(), piece.end(), piece.begin(), 0.0);
    out.freedom += static_cast<double>(piece.size()) - 1.0 - 2.0 * static_cast<double>(out.lines.size());
  }
  out.freedom = std::max(out.freedom, 1.0);
  const double variance = energy / out.freedom;
  out.sigma = std::sqrt(variance);
  if (variance <= 0.0) {
    out.bands = {{.from = 0.0, .to = 0.5 / interval, .density = 1.0, .freedom = out.freedom}};
    out.is_white = true;
    return out;
  }
  const std::vector<Coefficient> coefficients = coefficients_of(series, interval, variance);
  out.bands = bands_of(coefficients, 0.5 / interval);
  out.is_white = agree_with_white(out.bands);
  if (!out.is_white) out.low_end = low_end_of(coefficients, out.bands.front());
  return out;
}

}  // namespace coilwright::measurement::signals
