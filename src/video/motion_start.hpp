#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "coilwright/video/film_clock.hpp"

namespace coilwright::video {

/// How a tag begins to move.
struct MotionStart {
  Moment moment{};                 ///< mean and standard deviation of when it begins, 0 or more
  std::vector<double> repeated{};  ///< of each sample, 0 to 1: the probability that it shows the picture before again
};

/// The start of a motion from rest by the mean over all starts, damped courses and rates of it, each weighed by how
/// well it explains the samples. A sample may show the picture before once more, so that one at rest does not prove
/// that it was still at rest then. The sample `first`, 1 or more, is the first that has moved beyond doubt; `noise`
/// (rad) and `interval` (s) are those of a picture, above 0.
[[nodiscard]] MotionStart motion_start(std::span<const AngleSample> samples, std::size_t first, double rest,
                                       double noise, double interval);

}  // namespace coilwright::video
