#pragma once

#include <span>

#include "coilwright/measurement/data/run.hpp"
#include "coilwright/measurement/replay/declared_model.hpp"

namespace coilwright::measurement {

/// Refuses records, to be fitted or to be judged by, that were written under another convention than their columns say:
/// radians for degrees, an angle or a current of the other sign, milliamperes for amperes, frame numbers or
/// milliseconds for seconds. No effect undoes such a slip, and a diagnosis would name effects that stand in for it.
///
/// A slip is what makes the declared model, as it is, miss a motion that starts at rest by less than half of what it
/// varies and by less than a quarter of what it misses it by as it is written (0.7, for times that count by whole
/// numbers). The first two dozen motions are tried, each by itself. Throws RecordSlip naming run, column, both misses
/// and the remedy. Says nothing of sets without a motion that starts at rest.
void require_no_slip(std::span<const data::Run> runs, const replay::DeclaredModel& declared);

}  // namespace coilwright::measurement
