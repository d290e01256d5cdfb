#pragma once

#include <optional>

#include "coilwright/measurement/data/dataset.hpp"

namespace coilwright::measurement {

/// Says of a motion in which the camera or the tracker stops: its longest stretch of at least ten samples of one
/// channel that are exactly alike, where the noise of its other samples, of at least three times its resolution, would
/// show. Such a stretch looks like a finger that sticks. Nothing where there is none, and at the extremes of a channel:
/// there a sensor saturates, of which data::data_quality_warnings says more.
[[nodiscard]] std::optional<data::Warning> frozen_pictures(const data::Run& run);

}  // namespace coilwright::measurement
