#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "coilwright/measurement/data/dataset.hpp"
#include "coilwright/measurement/identification/posterior.hpp"
#include "coilwright/measurement/replay/tolerances.hpp"
#include "coilwright/text/json/json.hpp"

namespace coilwright::formats {

/// The content of the folder of a data set.
struct DatasetFile {
  std::string file;  ///< path of dataset.json, for errors about it
  measurement::data::Dataset data{};
  std::vector<std::filesystem::path> run_files{};  ///< of all its runs, and of their inputs
  std::vector<std::string> calibrate{};            ///< numbers of the declared model that may be fitted anew
  measurement::replay::Tolerances tolerances{};    ///< tolerances of its declared numbers
  std::vector<measurement::identification::Belief> beliefs{};  ///< of effects that may be missing
  std::optional<std::filesystem::path> actuator{};  ///< the declared model, where the set names one; not opened
};

/// Reads a measured-data/1 set: its dataset.json (or its folder) and every CSV file that it names. Validate runs are
/// read, so that faults of their files are reported at once, but warnings and refusals of implausible numbers concern
/// fit and still runs only. If no run is for validation, measurement::data::with_runs_held_out() holds some out. Its
/// effects must be among `known`. Throws InputError naming file, place and rule.
[[nodiscard]] DatasetFile read_dataset(const std::filesystem::path& path,
                                       const actuator::EffectCatalogue& known = actuator::standard_effects());

/// Parses the text of a dataset.json; its runs' files count from the folder of `file`.
[[nodiscard]] DatasetFile parse_dataset(std::string_view text, std::string file,
                                        const actuator::EffectCatalogue& known = actuator::standard_effects());

/// A run, and whether it is hidden from fits.
struct RunWithRole {
  const measurement::data::Run& run;
  bool validate{};
};

/// dataset.json of a measured-data/1 set; `actuator` is the declared model's file, counted from the set's folder.
[[nodiscard]] text::Json dataset_json(const std::string& name, const std::string& actuator,
                                      std::span<const RunWithRole> runs);

/// Writes the CSV file of a run: the columns of its kind, then its channels, in the units of their names, with twelve
/// digits. So 30.02 is not written as 30.020000000000003. An input on a clock of its own is not included.
void write_run(std::ostream& out, const measurement::data::Run& run);

/// The file name of a run's input if it has a clock of its own: "step_input.csv" for "step.csv"; absent if it has not.
[[nodiscard]] std::optional<std::string> input_file_name(const measurement::data::Run& run);

/// The file name of the input of a run with this name that has its own clock.
[[nodiscard]] std::string input_file_name(const std::string& run);

/// Writes the CSV file of such an input. Precondition: run.has_input_clock().
void write_input(std::ostream& out, const measurement::data::Run& run);

}  // namespace coilwright::formats
