#pragma once

#include <span>
#include <vector>

#include "video/robust_line.hpp"
#include "video/sighting_series.hpp"

namespace coilwright::video {

/// Time from a row's exposure to the next row's, s, by the skew of tags that move; estimated over all series. `rows`:
/// direction in which the rows follow each other, of unit length.
[[nodiscard]] LastCoefficient row_time_of(std::span<const std::vector<SeriesEntry>> series, const Place& rows);

/// Square of the exposure time, s^2, by the blur along the motion over that across.
[[nodiscard]] LastCoefficient squared_exposure_of(std::span<const std::vector<SeriesEntry>> series);

/// The shape of a tag as if all rows had been exposed when its middle was, to first order in the row time. `rows` as
/// above.
[[nodiscard]] Eigen::Matrix2d without_rolling(const SeriesEntry& entry, double row_time, const Place& rows);

}  // namespace coilwright::video
