#include "video/course_scatter.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <span>

namespace coilwright::video {
namespace {

using Samples = std::span<const AngleSample>;

constexpr std::size_t fewest_windows = 10;

double mean_variance(Samples samples) {
  double sum = 0.0;
  for (const AngleSample& each : samples) sum += each.sigma * each.sigma;
  return sum / static_cast<double>(samples.size());
}

// Variance beside the polynomial of an order that fits best.
double variance_beside(Samples samples, Eigen::Index order) {
  const auto count = static_cast<Eigen::Index>(samples.size());
  const double middle = 0.5 * (samples.front().time + samples.back().time);
  const double reach = 0.5 * (samples.back().time - samples.front().time);
  Eigen::MatrixXd powers = Eigen::MatrixXd::Ones(count, order + 1);
  Eigen::VectorXd angles(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const AngleSample& sample = samples[static_cast<std::size_t>(i)];
    for (Eigen::Index k = 1; k <= order; ++k) powers(i, k) = powers(i, k - 1) * (sample.time - middle) / reach;
    angles[i] = sample.angle - samples.front().angle;
  }
  const Eigen::VectorXd turned = powers.householderQr().householderQ().transpose() * angles;
  const Eigen::Index free = count - order - 1;
  return turned.tail(free).squaredNorm() / static_cast<double>(free);
}

bool moves(Samples samples) {
  constexpr double beyond_doubt = 5.0;
  const auto ends = std::ranges::minmax(samples, {}, &AngleSample::angle);
  return ends.max.angle - ends.min.angle > beyond_doubt * std::sqrt(mean_variance(samples));
}

// The variance beside polynomials through so many samples in a row that move, as a share of what the fits state.
// Compression holds what rests, and its error: that is not the noise.
std::optional<double> share_in_motion(Samples samples, double interval, std::size_t count, Eigen::Index order) {
  std::vector<double> variances;
  double stated = 0.0;
  for (std::size_t i = 0; i + count <= samples.size(); ++i) {
    const Samples window = samples.subspan(i, count);
    constexpr double gap = 1.5;
    const double usual = static_cast<double>(count - 1) * interval;
    if (window.back().time - window.front().time > gap * usual || !moves(window)) continue;
    variances.push_back(variance_beside(window, order));
    stated += mean_variance(window);
  }
  if (variances.size() < fewest_windows) return std::nullopt;
  const auto middle = variances.begin() + static_cast<std::ptrdiff_t>(variances.size() / 2);
  std::ranges::nth_element(variances, middle);
  // Where a current is switched, a course bends at once. The middle variance of three numbers is 0.79 of their mean
  // one, and of compressed films, whose pictures differ, down to 1/1.4 of that: what the mean has more is of bends.
  constexpr double most = 1.4 / 0.79;
  const double mean = std::accumulate(variances.begin(), variances.end(), 0.0) / static_cast<double>(variances.size());
  return std::min(mean, most * *middle) * static_cast<double>(variances.size()) / stated;
}

// The same of samples at rest, about their mean; nothing where compression repeats them.
std::optional<double> share_at_rest(Samples samples) {
  if (samples.size() < 2 * fewest_windows) return std::nullopt;
  double mean = 0.0;
  for (const AngleSample& each : samples) mean += each.angle / static_cast<double>(samples.size());
  double squares = 0.0;
  double differences = 0.0;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    squares += std::pow(samples[i].angle - mean, 2);
    differences += std::pow(samples[i].angle - samples[i - 1].angle, 2);
  }
  constexpr double repeated = 0.25;  // neighbours are correlated by more than 3/4
  if (0.5 * differences < repeated * squares) return std::nullopt;
  return squares / static_cast<double>(samples.size() - 1) / mean_variance(samples);
}

double share_shown(Samples samples, double interval) {
  const auto fine = share_in_motion(samples, interval, 11, 7);
  const auto coarse = share_in_motion(samples, interval, 9, 5);
  if (!fine || !coarse) return share_at_rest(samples).value_or(1.0);
  // Errors that change slowly, as a turned tag lies otherwise on the pixels or is copied by compression, go into the
  // course. Of rendered films the scatter beside it is 0.7 to 1.05 of the error.
  constexpr double with_slow = 1.5;
  // Where a course that may bend more leaves less, some of the scatter is the motion's: then the fits bound it.
  constexpr double followed = 0.8;
  return *fine < followed * *coarse ? std::min(1.0, with_slow * *fine) : with_slow * *fine;
}

}  // namespace

std::vector<AngleSample> with_shown_scatter(std::vector<AngleSample> samples, double interval) {
  const double share = share_shown(samples, interval);
  // A fit knows its variance from a dozen blocks of pixels: the mean of neighbours is nearer to theirs.
  constexpr std::size_t reach = 5;
  std::vector<double> sigmas;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const std::size_t first = i - std::min(i, reach);
    const Samples around = Samples(samples).subspan(first, std::min(samples.size(), i + reach + 1) - first);
    sigmas.push_back(std::sqrt(share * mean_variance(around)));
  }
  for (std::size_t i = 0; i < samples.size(); ++i) samples[i].sigma = sigmas[i];
  return samples;
}

}  // namespace coilwright::video
