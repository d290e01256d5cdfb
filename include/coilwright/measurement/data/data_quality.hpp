#pragma once

#include <vector>

#include "coilwright/measurement/data/dataset.hpp"

namespace coilwright::measurement::data {

/// What looks wrong with a run before any model is asked; every warning names the run. Looks for
/// - an input that never moves in a run that starts at rest under it;
/// - a channel that never changes;
/// - a reading that stays at its extreme, to the last digit, much longer than at any other value: a sensor at the end
/// of
///   its range (or a motion against a stop);
/// - a clock that jumps: an interval of more than 20 times the median one;
/// - numbers whose unit cannot be right: an angle of more than two turns, a current of more than 100 A, a coil below
///   -60 or above 400 degC.
/// A run with fewer than three samples gets none of those about repetition.
[[nodiscard]] std::vector<Warning> look_over(const Run& run);

}  // namespace coilwright::measurement::data
