#pragma once

#include <iosfwd>
#include <optional>
#include <span>
#include <string>

#include "coilwright/measurement/data/dataset.hpp"
#include "coilwright/text/json/json.hpp"

namespace coilwright::formats {

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
