#pragma once

#include <span>

#include "measurement/replay/prepared_run.hpp"

namespace coilwright::measurement::replay {

/// Gives a run the noise that was recorded while nothing moved: from still runs of the same kind of channel, otherwise
/// from those parts of `runs` (runs that start at rest, before their input changes) where together they are long
/// enough. A still run sets the level, unless the run gives one, and the colour; parts at rest set both only where they
/// show that the noise is not white, because the run itself tells the level of white noise better. Lines become local
/// numbers. Each NoiseLevel says what was assumed.
void give_recorded_noise(PreparedRun& prepared, std::span<const data::Run> still, std::span<const data::Run> runs);

}  // namespace coilwright::measurement::replay
