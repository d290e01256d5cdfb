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

/// When a tag begins to move, from the root of how far it has come, which is straight under a constant torque; nothing
/// where it does not. The torque's own rise makes it late.
[[nodiscard]] std::optional<Moment> onset_of(std::span<const AngleSample> samples, double interval);

/// When the LED is first lit; nothing where its light does not change by 25 grey. `row` is where it is.
[[nodiscard]] std::optional<Moment> led_lit(const TrackedFilm& film, const FingerMotion& motion, double row);

}  // namespace coilwright::video
