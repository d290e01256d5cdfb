#pragma once

#include <span>

#include "coilwright/measurement/planning/experiment.hpp"
#include "measurement/fit/fit.hpp"

namespace coilwright::measurement::planning {

/// The experiment that made these records, as far as they show it: of each motion its input, camera, clocks and rig,
/// and the instruments' noise, its colour, hum, outliers and the noise of the input column. `fit` tells how far
/// outliers are off. Inputs are the shapes that they are, if these have a name, otherwise tables. A motion that began
/// anywhere begins at rest here, under its first input.
[[nodiscard]] Experiment recorded_experiment(std::span<const replay::PreparedRun> runs, const fit::Fit& fit);

/// Whether an experiment/1 says of this run what was recorded: it began at rest, and its input is no long table.
[[nodiscard]] bool can_be_repeated(const PlannedRun& recorded);

}  // namespace coilwright::measurement::planning
