#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "coilwright/actuator/effect.hpp"
#include "coilwright/measurement/experiment/experiment.hpp"
#include "coilwright/measurement/replay/declared_model.hpp"

namespace coilwright::measurement::experiment {

/// The records that a rig would give which has the effects `hidden` beside what `rig` declares: one run a planned one,
/// in their order, with simulated, noisy and rounded values. The noise of a channel follows from `seed` and the places
/// of run and channel alone, so a run added at the end changes no other. The same input gives the same bits. Throws
/// std::invalid_argument naming the run where it does not fit the rig (number of coils or joints, a voltage without a
/// resistance, an effect that cannot be there), std::runtime_error naming it where its motion cannot be followed.
[[nodiscard]] std::vector<data::Run> act_out(const Experiment& experiment, const replay::DeclaredModel& rig,
                                             std::span<const actuator::Effect> hidden, std::uint64_t seed);

}  // namespace coilwright::measurement::experiment
