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

/// What the folder of a data set holds.
struct DatasetFile {
  std::string file;  ///< path of dataset.json, for errors about it
  measurement::data::Dataset data{};
  std::vector<std::filesystem::path> run_files{};  ///< of all its runs, and of their inputs
  std::vector<std::string> calibrate{};            ///< numbers of the declared model that may be fitted anew
  measurement::replay::Tolerances tolerances{};    ///< how well its declared numbers are known
  std::vector<measurement::identification::Belief> beliefs{};  ///< of effects that may be missing
  std::optional<std::filesystem::path> actuator{};  ///< the declared model, where the set names one; not opened
};

/// Reads a measured-data/1 set: its dataset.json (or the folder of it) and every CSV file it names. Validate runs are
/// read, so that a fault of their files is told at once, but nothing is concluded from their numbers: warnings, and
/// refusals of what cannot be right, are about fit and still runs only. A set that names no validate run has some held
/// out by measurement::data::with_runs_held_out(). Effects that it names are of `known`. Throws InputError naming file,
/// place and rule.
[[nodiscard]] DatasetFile read_dataset(const std::filesystem::path& path,
                                       const actuator::EffectCatalogue& known = actuator::standard_effects());

/// The same for the text of a dataset.json; its runs' files count from the folder of `file`.
[[nodiscard]] DatasetFile parse_dataset(std::string_view text, std::string file,
                                        const actuator::EffectCatalogue& known = actuator::standard_effects());

/// A run and whether fits must not see it.
struct RunWithRole {
  const measurement::data::Run& run;
  bool validate{};
};

/// dataset.json of a measured-data/1 set; `actuator` is the declared model's file, counted from the set's folder.
[[nodiscard]] text::Json dataset_json(const std::string& name, const std::string& actuator,
                                      std::span<const RunWithRole> runs);

/// The CSV file of a run: the columns of its kind, then its channels under their names, in the units of the names.
/// Twelve digits, far beyond any instrument: what a resolution of 0.02 deg made 30.02 is not written as
/// 30.020000000000003.
/// An input on a clock of its own is not among them.
void write_run(std::ostream& out, const measurement::data::Run& run);

/// The file of a run's input where that has a clock of its own, beside the run's: "step_input.csv" for "step.csv";
/// nothing where it has not.
[[nodiscard]] std::optional<std::string> input_file_name(const measurement::data::Run& run);

/// The same of a run of this name that has one.
[[nodiscard]] std::string input_file_name(const std::string& run);

/// The CSV file of such an input. Precondition: run.has_input_clock().
void write_input(std::ostream& out, const measurement::data::Run& run);

}  // namespace coilwright::formats
