#include "coilwright/video/film_clock.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "video/motion_start.hpp"

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
  constexpr double early = 0.35;  // of the whole way: what comes later says little of the begin
  const double bends = early * way(*std::ranges::max_element(samples, {}, way));
  const auto moving = std::ranges::find_if(samples, [&](const AngleSample& each) { return way(each) >= bends; });
  // The noise of pictures in which it moves: those before are frozen by compression, state less, and creep by more.
  constexpr std::ptrdiff_t few = 6;
  const double noise = median_sigma({moving, std::min(samples.end(), moving + few)});
  constexpr double seen = 3.0;  // standard deviations: all that follow are seen too
  auto first = moving;
  const double sign = moving->angle < rest ? -1.0 : 1.0;
  while (first != samples.begin() && sign * (std::prev(first)->angle - rest) > seen * noise) --first;
  constexpr double least_rest = 3.0;  // intervals: what moves when the film begins has begun before
  if (first->time - samples.front().time < least_rest * interval) return std::nullopt;
  constexpr std::ptrdiff_t resting = 12;
  constexpr std::ptrdiff_t least = 5;
  constexpr std::ptrdiff_t most = 16;
  const auto begin = first - std::min(resting, first - samples.begin());
  auto end = std::next(first);
  while (end != samples.end() && end - first < most && (end - first < least || way(*end) <= bends)) ++end;
  Moment out = motion_start({begin, end}, static_cast<std::size_t>(first - begin), rest, noise, interval).moment;
  out.sigma = std::hypot(interval, out.sigma);  // the torque's rise and the stamps are not known better
  return out;
}

bool is_known_to_two_pictures(const Moment& moment, double interval) {
  constexpr double most = 2.0;  // pictures to either side, all alike: a standard deviation of that over the root of 3
  return moment.sigma <= std::hypot(1.0, most / std::sqrt(3.0)) * interval;
}

std::optional<Moment> led_lit(const TrackedFilm& film, const FingerMotion& motion, const Place& led) {
  // No structured binding: Clang 14 does not let a lambda take one.
  const auto ends = std::ranges::minmax(film.frames, {}, &Frame::led);
  const double low = ends.min.led, high = ends.max.led;
  constexpr double least = 25.0;
  if (high - low < least) return std::nullopt;
  const double scale = motion.time_scale;
  const auto share = [&](const Frame& frame) { return (frame.led - low) / (high - low); };
  const auto lit = std::ranges::find_if(film.frames, [&](const Frame& frame) { return share(frame) > 0.1; });
  if (lit == film.frames.begin()) return std::nullopt;
  const double later = motion.readout.value * share_of_readout(film, led);
  const double exposure = motion.exposure.value;
  // A picture that it lit in part tells when; otherwise it was between two exposures.
  const double partly = share(*lit);
  const double before = std::prev(lit)->time * scale + 0.5 * exposure;
  const double after = lit->time * scale - 0.5 * exposure;
  const bool seen = partly < 0.9 && exposure > 0.0;
  const double time = seen ? lit->time * scale + (0.5 - partly) * exposure : 0.5 * (before + after);
  const double open = seen ? 0.0 : after - before;  // more than an interval where pictures are not there
  return Moment{.time = time + later, .sigma = std::max(motion.interval, open) / std::sqrt(12.0)};
}

}  // namespace coilwright::video
