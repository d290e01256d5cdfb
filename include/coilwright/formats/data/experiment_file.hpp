#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "coilwright/measurement/planning/experiment.hpp"
#include "coilwright/text/json/json.hpp"

namespace coilwright::formats {

/// Reads an experiment/1: the runs that somebody plans, and the instruments that would record them. Keys, units and
/// defaults are in docs/formats-experiment.md. Throws InputError.
[[nodiscard]] measurement::planning::Experiment read_experiment(const std::filesystem::path& path);

/// The same for a text in memory; `file` is the name its errors carry, and files of inputs count from its folder.
[[nodiscard]] measurement::planning::Experiment parse_experiment(std::string_view text, std::string file);

/// Sets the noise of one instrument as an argument says, "angle_deg=0.3"; the keys are those of the file. Throws
/// InputError whose file is the argument: `angle_deg=-1: must be >= 0`.
void set_noise(measurement::planning::Instruments& instruments, std::string_view argument);

/// The experiment as an experiment/1, which read_experiment() reads back: every run with all that it does not take from
/// a default of the format, an input from a file as `levels`. `description` is left out where it is empty. Throws
/// std::invalid_argument for a bench that the format has no keys for (openings and heights of a grasp, torques that are
/// not every angle under every current).
[[nodiscard]] text::Json experiment_json(const measurement::planning::Experiment& experiment,
                                         const std::string& description = {});

/// A run that an experiment/1 can list under `runs`. Throws as experiment_json() does.
[[nodiscard]] text::Json run_json(const measurement::planning::PlannedRun& run);

}  // namespace coilwright::formats
