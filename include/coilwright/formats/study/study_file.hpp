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

/// What a command line changes of a study before it is read, each `NAME=VALUE`: a number of the study's own actuator
/// ("gap_mm=1.2", see with_assignment()), or of the study's file by its JSON pointer ("/search/seed=3").
using StudyChanges = std::vector<std::string>;

/// Where a study's file has the number of a block that its variables and results call by that name: "/driver/voltage_V"
/// of "driver_voltage_V", and "/driver/voltage_V=8" of an assignment to it; nothing for a name that begins like no
/// block's.
[[nodiscard]] std::optional<std::string> block_pointer(std::string_view name);

/// How a study is read, where its files alone do not say it.
struct StudyReading {
  /// Objectives and constraints name rows of it, and the study keeps it as the table of its results.
  const simulation::QuantityTable& quantities = simulation::standard_quantities();
  const actuator::EffectCatalogue& effects = actuator::standard_effects();  ///< of which the actuator's are
  /// Made first. What the study varies, they cannot set: that is an InputError, as is a name or a value that does not
  /// exist.
  StudyChanges changes{};
  /// Texts in place of files that the study names, whatever it names; nullptr: the file is read.
  ///@{
  const text::InputText* actuator{};
  const text::InputText* posterior{};
  ///@}
};

/// Reads a study (`"format": "study/1"`) and the actuator it names, whose path counts from the study's folder. Keys are
/// in docs/formats.md. Throws InputError, also for what contradicts itself: a bound that crosses another, a limit that
/// no value can meet together with another one, a current that is both fixed and varied.
[[nodiscard]] sizing::Study read_study(const std::filesystem::path& path, const StudyReading& reading = {});

/// The same for a text in memory; `file` is the name its errors carry, and the actuator's path counts from its folder.
[[nodiscard]] sizing::Study parse_study(std::string_view text, std::string file, const StudyReading& reading = {});

/// A study and what of its file it does not keep.
struct StudyFile {
  sizing::Study study;
  std::filesystem::path actuator;                  ///< the file of its own actuator
  std::optional<std::filesystem::path> posterior;  ///< the diagnosis of its spread; nothing: it has none
  bool builds_a_system{};                          ///< it has a block "gripper", "crawler" or "driver"
};

/// The same with that.
[[nodiscard]] StudyFile parse_study_file(std::string_view text, std::string file, const StudyReading& reading = {});

/// How many objectives a command takes.
struct ObjectiveCount {
  std::size_t least{};
  std::size_t most{};
  std::string_view rule;  ///< end of a sentence
};
inline constexpr ObjectiveCount objectives_of_size{1, 1, "must be one for size (pareto takes two or three)"};
inline constexpr ObjectiveCount objectives_of_pareto{2, 3, "must be two or three for pareto (size takes one)"};
inline constexpr ObjectiveCount objectives_of_sweep{1, 3, "must be one to three for sweep"};

/// Throws InputError of the study's `file` where it has another number of objectives.
void require_objectives(const sizing::Study& study, const ObjectiveCount& count, const std::string& file);

}  // namespace coilwright::formats
