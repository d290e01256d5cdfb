#pragma once

#include <span>

#include "coilwright/measurement/data/run.hpp"
#include "coilwright/measurement/replay/declared_model.hpp"

namespace coilwright::measurement::records {

/// Refuses records, to be fitted or to be judged by, that were written under another convention than their columns say:
/// another unit, an angle, a current or a reading of the other sign, frame numbers for seconds (other_readings). No
/// effect undoes such a slip, and a diagnosis would name effects that stand in for it.
///
/// Of a motion that starts at rest, and of a temperature, a slip is what makes the declared model, as it is, miss the
/// record by less than half of what it varies and by less than a quarter of what it misses it by as it is written (0.7,
/// for times that count by whole numbers). Degrees of another thermometer also put the first reading four times nearer
/// to the ambient temperature, where every such record begins; then missing half as much is enough, as the rise may be
/// wrong by some factor. Of torques, forces and rates, which the model may miss by a factor of 3, sizes are compared by
/// their ratio: the slip is five times nearer, on the scale of logarithms, and what is left is of the declared shape.
///
/// The first two dozen motions and all benches are tried, each by itself. Throws RecordSlip naming run, column, both
/// misses and the remedy. Of motions without an angle or with another start, and where the model follows the times in
/// no unit, it tells times that are none by their spacing (require_possible_clock). Says nothing of still runs.
void require_no_slip(std::span<const data::Run> runs, const replay::DeclaredModel& declared);

}  // namespace coilwright::measurement::records
