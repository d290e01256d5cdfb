#pragma once

#include <vector>

#include "coilwright/measurement/data/dataset.hpp"

namespace coilwright::measurement::data {

/// Warnings about a run that need no model; each names the run. They report
/// - an input that never changes in a run that starts at rest under it;
/// - a channel that never changes;
/// - a reading that stays at its extreme, to the last digit, much longer than at any other value: the sensor is at the
///   end of its range, or the motion is against a stop (not of a still run, which rests anyway);
/// - a gap in the clock: an interval of more than 20 times the median one;
/// - numbers whose unit cannot be right: an angle of more than two turns, a current of more than 100 A, a coil below
///   -60 or above 400 degC.
/// A run with fewer than three samples gets no warning about repeated values or intervals.
[[nodiscard]] std::vector<Warning> data_quality_warnings(const Run& run);

}  // namespace coilwright::measurement::data
