#pragma once

#include "measurement/replay/prepared_run.hpp"

namespace coilwright::measurement::replay {

/// What the first samples of a range tell of the state in which it starts. The noise levels of `prepared` must be
/// there.
[[nodiscard]] InitialStatePrior initial_state_prior(const PreparedRun& prepared, SampleRange range,
                                                    const actuator::Model& nominal);

}  // namespace coilwright::measurement::replay
