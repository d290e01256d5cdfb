#include "measurement/signals/whitener.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace coilwright::measurement::signals {
namespace {

constexpr std::size_t highest_order = 200;
// Variance of the white noise that is added, over that of the noise: the structure that tests allow is as large.
constexpr double floor_variance = 1e-3;
// Points of the spectrum over which its autocovariance is summed.
constexpr std::size_t frequencies = 4096;

// The mean density between two frequencies, which may be far apart in their logarithms.
double mean_density(const NoiseColour& colour, double from, double to) {
  constexpr int parts = 64;
  double sum = 0.0;
  for (int i = 0; i < parts; ++i) sum += colour.density_at(from + (i + 0.5) / parts * (to - from));
  return sum / parts;
}

// Autocovariances at 0, 1, 2, ... intervals, in units of sigma^2: the cosine transform of the density. Without a low
// end their sum is one; what it adds below the lowest band's level comes on top, as no record of that length shows it.
std::vector<double> autocovariances(const NoiseColour& colour, double interval) {
  const double nyquist = colour.bands.back().to;
  std::vector<double> densities(frequencies);
  double sum = 0.0;
  NoiseColour shown = colour;
  shown.low_end.reset();
  for (std::size_t i = 0; i < frequencies; ++i) {
    const double width = nyquist / frequencies;
    const double frequency = (static_cast<double>(i) + 0.5) / frequencies * nyquist;
    const bool is_low = colour.low_end && frequency < colour.low_end->to;
    densities[i] = is_low ? mean_density(colour, static_cast<double>(i) * width, (static_cast<double>(i) + 1.0) * width)
                          : colour.density_at(frequency);
    sum += shown.density_at(frequency);
  }
  std::vector<double> out(highest_order + 1);
  for (std::size_t lag = 0; lag < out.size(); ++lag) {
    const double turn = 2.0 * std::numbers::pi * interval * static_cast<double>(lag) * nyquist / frequencies;
    for (std::size_t i = 0; i < frequencies; ++i)
      out[lag] += densities[i] / sum * std::cos(turn * (static_cast<double>(i) + 0.5));
  }
  out[0] += floor_variance;
  return out;
}

}  // namespace

Whitener::Whitener(const NoiseColour& colour, double interval) : colour_(colour), interval_(interval) {
  const std::vector<double> covariance = autocovariances(colour, interval);
  std::vector<double> predictor;  // x(t) is about the sum of predictor[i] x(t - 1 - i)
  double error = covariance[0];
  deviations_.push_back(std::sqrt(error));
  for (std::size_t order = 1; order <= highest_order; ++order) {
    double left = covariance[order];
    for (std::size_t i = 0; i < predictor.size(); ++i) left -= predictor[i] * covariance[order - 1 - i];
    const double reflection = left / error;
    std::vector<double> next(order);
    for (std::size_t i = 0; i + 1 < order; ++i) next[i] = predictor[i] - reflection * predictor[order - 2 - i];
    next[order - 1] = reflection;
    predictor = std::move(next);
    error *= 1.0 - reflection * reflection;
    reflections_.push_back(reflection);
    deviations_.push_back(std::sqrt(error));
  }
}

void Whitener::apply(Eigen::Ref<Eigen::VectorXd> stretch) const {
  const Eigen::Index n = stretch.size();
  Eigen::VectorXd forward = stretch;
  Eigen::VectorXd backward =
      stretch;  // at order m: backward[t] is the error of x(t - m) predicted from what follows it
  const auto orders = std::min<Eigen::Index>(n - 1, static_cast<Eigen::Index>(reflections_.size()));
  for (Eigen::Index m = 1; m <= orders; ++m) {
    const double k = reflections_[static_cast<std::size_t>(m - 1)];
    // From the end, because backward[t] takes the place of backward[t - 1] of the order before.
    for (Eigen::Index t = n - 1; t >= m; --t) {
      const double ahead = forward[t];
      const double behind = backward[t - 1];
      forward[t] = ahead - k * behind;
      backward[t] = behind - k * ahead;
    }
  }
  for (Eigen::Index t = 0; t < n; ++t)
    stretch[t] = forward[t] / deviations_[static_cast<std::size_t>(std::min(t, orders))];
}

}  // namespace coilwright::measurement::signals
