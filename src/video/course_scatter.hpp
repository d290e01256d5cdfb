#pragma once

#include <vector>

#include "coilwright/video/finger_motion.hpp"

namespace coilwright::video {

/// The samples with the standard deviations that their angles show, where there are enough of them: those of the fits
/// say which pictures are better than others, the scatter beside a smooth course says how good they all are.
/// `interval`: s, between pictures.
[[nodiscard]] std::vector<AngleSample> with_shown_scatter(std::vector<AngleSample> samples, double interval);

}  // namespace coilwright::video
