#include "coilwright/video/film_clock.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <vector>

namespace coilwright::video {
namespace {

constexpr double far = 5.0;  // standard deviations

double mean_of(std::span<const AngleSample> samples) {
  double sum = 0.0;
  for (const AngleSample& each : samples) sum += each.angle;
  return samples.empty() ? 0.0 : sum / static_cast<double>(samples.size());
}

double median_sigma(std::span<const AngleSample> samples) {
  std::vector<double> sigmas;
  for (const AngleSample& each : samples) sigmas.push_back(each.sigma);
  const auto middle = sigmas.begin() + static_cast<std::ptrdiff_t>(sigmas.size() / 2);
  std::ranges::nth_element(sigmas, middle);
  return *middle;
}

// Where a line of time over the root of the way has come no way. Noise of an angle is one of its root over twice the
// root. All count alike: by their noise alone the later ones would decide, where the line bends.
Moment rest_by_line(const Eigen::ArrayXd& roots, const Eigen::ArrayXd& times, double noise, double interval) {
  const Eigen::ArrayXd apart = roots - roots.mean();
  const double squares = apart.square().sum();
  if (squares <= 1e-9 * roots.square().sum()) return {.time = times[0] - 0.5 * interval, .sigma = interval};
  const Eigen::ArrayXd shares = 1.0 / static_cast<double>(roots.size()) - roots.mean() / squares * apart;
  const double slope = (apart * times).sum() / squares;
  const double error = 0.5 * noise * slope * (shares / roots).matrix().norm();
  return {.time = (shares * times).sum(), .sigma = std::hypot(interval, error)};
}

}  // namespace

std::size_t still_samples(std::span<const AngleSample> samples) {
  double sum = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double mean = i == 0 ? samples[0].angle : sum / static_cast<double>(i);
    const auto next = samples.subspan(i, std::min<std::size_t>(3, samples.size() - i));
    if (std::ranges::all_of(next, [&](const auto& each) { return std::abs(each.angle - mean) > far * each.sigma; }))
      return i;
    sum += samples[i].angle;
  }
  return samples.size();
}

std::optional<Moment> onset_of(std::span<const AngleSample> samples, double interval) {
  const std::size_t still = still_samples(samples);
  if (still == 0 || still == samples.size()) return std::nullopt;
  const double rest = mean_of(samples.first(still));
  const auto way = [&](const AngleSample& each) { return std::abs(each.angle - rest); };
  constexpr double early = 0.35;  // of the whole way: beyond, springs and dampers bend the line
  const double bends = early * way(*std::ranges::max_element(samples, {}, way));
  const auto moving = std::ranges::find_if(samples, [&](const AngleSample& each) { return way(each) >= bends; });
  // The noise of pictures in which it moves: those before are frozen by compression, state less, and creep by more.
  constexpr std::ptrdiff_t few = 6;
  const double noise = median_sigma({moving, std::min(samples.end(), moving + few)});
  constexpr double seen = 3.0;  // standard deviations: all that follow are seen too
  auto first = moving;
  while (first != samples.begin() && way(*std::prev(first)) > seen * noise) --first;
  // Until it is twice as fast, where that is not too few: then the line bends.
  auto last = first;
  while (++last != samples.end() && way(*last) <= bends && (last - first < few || way(*last) < 4.0 * way(*first))) {
  }
  Eigen::ArrayXd roots(last - first);
  Eigen::ArrayXd times(last - first);
  for (Eigen::Index i = 0; i < roots.size(); ++i) {
    roots[i] = std::sqrt(way(first[i]));
    times[i] = first[i].time;
  }
  Moment out = rest_by_line(roots, times, noise, interval);
  out.time = std::clamp(out.time, samples.front().time, first->time);
  return out;
}

std::optional<Moment> led_lit(const TrackedFilm& film, const FingerMotion& motion, double row) {
  // No structured binding: Clang 14 does not let a lambda take one.
  const auto ends = std::ranges::minmax(film.frames, {}, &Frame::led);
  const double low = ends.min.led, high = ends.max.led;
  constexpr double least = 25.0;
  if (high - low < least) return std::nullopt;
  const double scale = motion.time_scale;
  const auto share = [&](const Frame& frame) { return (frame.led - low) / (high - low); };
  const auto lit = std::ranges::find_if(film.frames, [&](const Frame& frame) { return share(frame) > 0.1; });
  if (lit == film.frames.begin()) return std::nullopt;
  const double later = motion.readout.value * (row / film.height - 0.5);
  const double exposure = motion.exposure.value;
  // A picture that it lit in part tells when; otherwise it was between two exposures.
  const double partly = share(*lit);
  const double before = std::prev(lit)->time * scale + 0.5 * exposure;
  const double after = lit->time * scale - 0.5 * exposure;
  const double time =
      partly < 0.9 && exposure > 0.0 ? lit->time * scale + (0.5 - partly) * exposure : 0.5 * (before + after);
  return Moment{.time = time + later, .sigma = motion.interval / std::sqrt(12.0)};
}

}  // namespace coilwright::video
