#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "coilwright/simulation/quantity.hpp"
#include "coilwright/sizing/study/study.hpp"
#include "coilwright/text/input_text.hpp"

namespace coilwright::formats {

/// Changes that a command line makes to a study before it is read, each `NAME=VALUE`: a number of the study's own
/// actuator ("gap_mm=1.2", see with_assignment()), or a value of the study's file by its JSON pointer
/// ("/search/seed=3").
using StudyChanges = std::vector<std::string>;

/// The JSON pointer in a study's file of a number that variables and results call by that name: "/driver/voltage_V" for
/// "driver_voltage_V", and "/driver/voltage_V=8" for an assignment to it; absent for a name that begins like no
/// block's.
[[nodiscard]] std::optional<std::string> block_pointer(std::string_view name);

/// Settings for reading a study that are not in its files.
struct StudyReading {
  /// The rows that objectives and constraints may name. The study keeps it as the table of its results.
  const simulation::QuantityTable& quantities = simulation::standard_quantities();
  const actuator::EffectCatalogue& effects = actuator::standard_effects();  ///< of which the actuator's are
  /// Changes that are made first. Throws InputError for a name or a value that does not exist, and for a number that
  /// the study varies.
  StudyChanges changes{};
  /// Texts that are read instead of the files that the study names; nullptr: the file is read. @{
  const text::InputText* actuator{};
  const text::InputText* posterior{};
  ///@}
};

/// Reads a study (`"format": "study/1"`) and the actuator that it names, whose path counts from the study's folder.
/// Keys are in docs/formats-study.md. Throws InputError, also for contradictions: a bound that crosses another, a limit
/// that no value can meet together with another one, a current that is both fixed and varied.
[[nodiscard]] sizing::Study read_study(const std::filesystem::path& path, const StudyReading& reading = {});

/// Parses a study from a text in memory; errors call it `file`, and the actuator's path counts from its folder.
[[nodiscard]] sizing::Study parse_study(std::string_view text, std::string file, const StudyReading& reading = {});

/// A study, and the parts of its file that it does not keep.
struct StudyFile {
  sizing::Study study;
  std::filesystem::path actuator;                  ///< the file of its own actuator
  std::optional<std::filesystem::path> posterior;  ///< the diagnosis of its spread; absent: it has none
  bool builds_a_system{};                          ///< whether it has a block "gripper", "crawler" or "driver"
};

/// Parses a study together with those parts of its file.
[[nodiscard]] StudyFile parse_study_file(std::string_view text, std::string file, const StudyReading& reading = {});

/// The numbers of objectives that a command accepts.
struct ObjectiveCount {
  std::size_t least{};
  std::size_t most{};
  std::string_view rule;  ///< the rule, as the end of a sentence
};
inline constexpr ObjectiveCount objectives_of_size{1, 1, "must be one for size (pareto takes two or three)"};
inline constexpr ObjectiveCount objectives_of_pareto{2, 3, "must be two or three for pareto (size takes one)"};
inline constexpr ObjectiveCount objectives_of_sweep{1, 3, "must be one to three for sweep"};

/// Throws InputError of the study's `file` if it has another number of objectives.
void require_objectives(const sizing::Study& study, const ObjectiveCount& count, const std::string& file);

}  // namespace coilwright::formats
