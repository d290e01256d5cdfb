#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "coilwright/video/finger_motion.hpp"

namespace coilwright::video {

/// How many samples come before a tag begins to move: before three in a row are further than five of their standard
/// deviations from the mean of those before. All where none are.
[[nodiscard]] std::size_t still_samples(std::span<const AngleSample> samples);

/// A moment on the container's clock.
struct Moment {
  double time{};   ///< s
  double sigma{};  ///< s
};

/// When a tag begins to move, by what it does from rest under a torque that is constant or rises to that; nothing where
/// it does not move, or not after a rest of three intervals. Pictures that were not read, or may show the one before
/// once more, enter `sigma`, which is never below an interval. A torque that comes after the current makes it late.
[[nodiscard]] std::optional<Moment> onset_of(std::span<const AngleSample> samples, double interval);

/// Whether a moment is known to two pictures: at least as well as one that lies anywhere within two intervals to either
/// side of it, with an interval for what no picture shows.
[[nodiscard]] bool is_known_to_two_pictures(const Moment& moment, double interval);

/// When the LED is first lit; nothing where its light does not change by 25 grey. `led` is where it is, px. Pictures
/// that are not there enter `sigma`.
[[nodiscard]] std::optional<Moment> led_lit(const TrackedFilm& film, const FingerMotion& motion, const Place& led);

}  // namespace coilwright::video
