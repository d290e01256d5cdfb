#pragma once

#include <vector>

#include "coilwright/measurement/experiment/experiment_plan.hpp"

namespace coilwright::measurement::experiment {

/// Runs that could be added to an experiment, within the levels that it commands already, recorded as its first motion
/// is: steps, sines, a chirp, a release, a long hold, a reversed step, and a step on a changed rig. Their worth is not
/// known yet. None if the experiment has no motion that is commanded.
[[nodiscard]] std::vector<AddedRun> runs_to_add(const Experiment& experiment, const actuator::Model& nominal);

}  // namespace coilwright::measurement::experiment
