#include "coilwright/measurement/require_no_slip.hpp"

#include "measurement/final_errors.hpp"
#include "measurement/records/possible_clock.hpp"
#include "measurement/records/record_slips.hpp"

namespace coilwright::measurement {

void require_no_slip(const data::Dataset& data, const replay::DeclaredModel& declared) {
  records::require_no_slip(data.fit, declared);
  FinalErrors::require_no_slip(data.validate, declared);
  records::require_possible_clocks(data.still);
}

}  // namespace coilwright::measurement
