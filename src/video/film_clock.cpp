#include "coilwright/video/film_clock.hpp"

#include <algorithm>
#include <cmath>

namespace coilwright::video {
namespace {

constexpr double far = 5.0;  // standard deviations

double mean_of(std::span<const AngleSample> samples) {
  double sum = 0.0;
  for (const AngleSample& each : samples) sum += each.angle;
  return samples.empty() ? 0.0 : sum / static_cast<double>(samples.size());
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
  const std::size_t first = still_samples(samples);
  if (first == 0 || first == samples.size()) return std::nullopt;
  const double rest = mean_of(samples.first(first));
  double largest = 0.0;
  for (const AngleSample& each : samples) largest = std::max(largest, std::abs(each.angle - rest));
  constexpr double early = 0.35;  // of the whole way: beyond, springs and dampers bend the line
  constexpr std::size_t most = 6;
  // A line through time over root, where it has come no way; noise of an angle is one of its root over twice the root.
  double weight = 0.0;
  double times = 0.0;
  double roots = 0.0;
  double squares = 0.0;
  double products = 0.0;
  std::size_t count = 0;
  for (const AngleSample& each : samples.subspan(first, std::min(most, samples.size() - first))) {
    const double way = std::abs(each.angle - rest);
    if (count++ > 0 && way > early * largest) break;
    const double root = std::sqrt(way);
    const double since = each.time - samples[first].time;
    weight += way;
    times += way * since;
    roots += way * root;
    squares += way * way;
    products += way * root * since;
  }
  const double spread = weight * squares - roots * roots;
  double onset = samples[first].time - 0.5 * interval;
  if (spread > 1e-9 * weight * squares) onset = samples[first].time + (squares * times - roots * products) / spread;
  constexpr double reach = 3.0;  // intervals: what moved earlier would have been seen
  return Moment{.time = std::clamp(onset, samples[first].time - reach * interval, samples[first].time),
                .sigma = interval};
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
