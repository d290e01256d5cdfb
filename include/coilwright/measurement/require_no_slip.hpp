#pragma once

#include "coilwright/measurement/data/dataset.hpp"
#include "coilwright/measurement/replay/declared_model.hpp"

namespace coilwright::measurement {

/// Refuses records, to be fitted or to be judged by, that were written under another convention than their columns say:
/// another unit, an angle, a current or a reading of the other sign, numbers of pictures for seconds. `declared` as it
/// is tells it: it follows such a record in the other convention, and not as it is written. Costs some simulations of
/// each motion. Throws records::RecordSlip naming run, column, both misses and the remedy; std::invalid_argument if a
/// run does not fit the model.
void require_no_slip(const data::Dataset& data, const replay::DeclaredModel& declared);

}  // namespace coilwright::measurement
