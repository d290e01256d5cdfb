#pragma once

#include <string>

#include "coilwright/measurement/experiment/experiment.hpp"
#include "coilwright/text/json/json.hpp"

namespace coilwright::formats {

/// The experiment as an experiment/1, which read_experiment() reads back: every run with all that it does not take from
/// a default of the format, an input from a file as `levels`. `description` is left out where it is empty. Throws
/// std::invalid_argument for a bench that the format has no keys for (openings and heights of a grasp, torques that are
/// not every angle under every current).
[[nodiscard]] text::Json experiment_json(const measurement::experiment::Experiment& experiment,
                                         const std::string& description = {});

/// A run that an experiment/1 can list under `runs`. Throws as experiment_json() does.
[[nodiscard]] text::Json run_json(const measurement::experiment::PlannedRun& run);

}  // namespace coilwright::formats
