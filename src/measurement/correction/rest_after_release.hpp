#pragma once

#include "measurement/correction/visited_states.hpp"

namespace coilwright::measurement::correction {

/// Whether `corrected`, let go at the farthest poses that were visited under the currents there and under none, comes
/// to rest as `without` does: a torque that was fitted to motions must not keep a motion going by itself. False too
/// where its motion cannot be simulated.
[[nodiscard]] bool comes_to_rest(const actuator::Model& corrected, const actuator::Model& without,
                                 const VisitedStates& visited);

}  // namespace coilwright::measurement::correction
