#pragma once

#include <span>

#include "measurement/replay/prepared_run.hpp"

namespace coilwright::measurement::replay {

/// Gives a run the noise that was recorded while nothing moved: from still runs of the same kind of channel, otherwise
/// from those parts of `runs` (runs that start at rest, before their input changes) where together they are long
/// enough. A still run sets the level, unless the run gives one, and the colour; parts at rest set both only where they
/// show that the noise is not white, because the run itself tells the level of white noise better. Lines become local
/// numbers: hum. A line within a tenth of a natural frequency of `model`, as the samples show it, is none, and what
/// swings so before its input changes is not at rest. Each NoiseLevel says what was assumed.
void give_recorded_noise(PreparedRun& prepared, std::span<const data::Run> still, std::span<const data::Run> runs,
                         const actuator::Model& model);

/// The same anew for all runs of a fit, once `model` has been fitted: `shown` is what the instruments show of it in
/// each (PreparedRun::sample_ranges). Where nothing else tells of hum, it is taken from the parts under a constant
/// input in which the model, too, stands still but for a drift. Returns whether lines or colours are others than
/// before.
[[nodiscard]] bool give_recorded_noise(std::span<PreparedRun> prepared, std::span<const data::Run> still,
                                       std::span<const data::Run> runs, const actuator::Model& model,
                                       std::span<const Eigen::VectorXd> shown);

}  // namespace coilwright::measurement::replay
