#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "coilwright/measurement/planning/experiment.hpp"
#include "coilwright/text/json/json.hpp"

namespace coilwright::formats {

/// Reads an experiment/1: planned runs, and the instruments that would record them. Keys, units and defaults are in
/// docs/formats-experiment.md. Throws InputError.
[[nodiscard]] measurement::planning::Experiment read_experiment(const std::filesystem::path& path);

/// Parses an experiment from a text in memory; errors call it `file`, and files of inputs count from its folder.
[[nodiscard]] measurement::planning::Experiment parse_experiment(std::string_view text, std::string file);

/// Sets the noise of one instrument from an argument, "angle_deg=0.3"; the keys are those of the file. Throws
/// InputError whose file is the argument: `angle_deg=-1: must be >= 0`.
void set_noise(measurement::planning::Instruments& instruments, std::string_view argument);

/// The experiment as an experiment/1 that read_experiment() reads back: every run with all values that are not the
/// format's defaults, an input from a file as `levels`. An empty `description` is left out. Throws
/// std::invalid_argument for a bench that the format cannot express (openings and heights of a grasp, torques that are
/// not every angle under every current).
[[nodiscard]] text::Json experiment_json(const measurement::planning::Experiment& experiment,
                                         const std::string& description = {});

/// A run as an entry under `runs` of an experiment/1. Throws as experiment_json() does.
[[nodiscard]] text::Json run_json(const measurement::planning::PlannedRun& run);

}  // namespace coilwright::formats
