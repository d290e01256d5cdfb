#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "coilwright/video/finger_motion.hpp"

namespace coilwright::video {

/// Number of samples before a tag begins to move: before three in a row are further than five of their standard
/// deviations from the mean of those before. All if it does not move.
[[nodiscard]] std::size_t still_samples(std::span<const AngleSample> samples);

/// A moment on the container's clock.
struct Moment {
  double time{};   ///< s
  double sigma{};  ///< s
};

/// The time at which a tag begins to move, from its motion from rest under a torque that is constant or rises to a
/// constant. Absent if the tag does not move, or has no rest of three intervals before. Pictures that were not read, or
/// may show the one before once more, increase `sigma`, which is never below an interval. A torque that lags behind the
/// current delays the result.
[[nodiscard]] std::optional<Moment> onset_of(std::span<const AngleSample> samples, double interval);

/// Whether a moment is known to two pictures: at least as well as one that lies anywhere within two intervals to either
/// side of it, with a further interval for what no picture shows.
[[nodiscard]] bool is_known_to_two_pictures(const Moment& moment, double interval);

/// The time at which the LED is first lit; absent if its light does not change by 25 grey. `led` is its place, px.
/// Missing pictures increase `sigma`.
[[nodiscard]] std::optional<Moment> led_lit(const TrackedFilm& film, const FingerMotion& motion, const Place& led);

}  // namespace coilwright::video
