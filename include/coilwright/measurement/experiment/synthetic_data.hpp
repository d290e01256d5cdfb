#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "coilwright/actuator/model/effect.hpp"
#include "coilwright/measurement/experiment/experiment.hpp"
#include "coilwright/measurement/replay/declared_model.hpp"

namespace coilwright::measurement::experiment {

/// Synthetic records of `rig` with the additional effects `hidden`: one simulated, noisy, quantised run per planned
/// run, in order. The noise of a channel depends only on `seed` and on the indices of run and channel, so a run that is
/// added at the end changes no other. The same input gives the same bits. Throws std::invalid_argument naming the run
/// if it does not fit the rig (number of coils or joints, a voltage without a resistance, an effect that the rig cannot
/// have), std::runtime_error naming it if its motion cannot be simulated.
[[nodiscard]] std::vector<data::Run> simulate_experiment(const Experiment& experiment, const replay::DeclaredModel& rig,
                                                         std::span<const actuator::Effect> hidden, std::uint64_t seed);

}  // namespace coilwright::measurement::experiment
