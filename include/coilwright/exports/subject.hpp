#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "coilwright/actuator/assemble.hpp"
#include "coilwright/actuator/design/design.hpp"
#include "coilwright/actuator/model/model.hpp"
#include "coilwright/actuator/operating_point.hpp"

namespace coilwright::exports {

/// The origin of an export, as the exported files state it.
struct Origin {
  std::string name;     ///< of the actuator, one line of UTF-8; may be empty
  std::string made_by;  ///< one line of UTF-8: program, version, input file and what was changed of it; may be empty
};

/// An actuator whose geometry is known.
struct DesignSubject {
  Origin origin;
  actuator::Design design;
  actuator::Assembly assembly;                                ///< of `design`
  std::optional<actuator::OperatingPoint> operating_point{};  ///< the operating point for which it was sized
};

/// An actuator of which only the model is known or wanted.
struct ModelSubject {
  Origin origin;
  actuator::Model model;
};

/// The subject of an export: a design (actuator/1) or a lumped model (lumped-model/1).
using Subject = std::variant<DesignSubject, ModelSubject>;

/// Settings of an export beside the actuator. Each kind of export reads those that its row names.
struct ExportSettings {
  /// Length of each of the two leads of a coil, m; >= 0. Resistance and mass of the leads are stated separately from
  /// the coil's.
  double lead_length = 0.15;
  /// Silicone that stays in cups, on tools and in the mould's seam, relative to that in the actuator; >= 0.
  double waste = 0.25;
  /// Mass of part A of the silicone over that of part B. 0 if it is not known; then only the sum of both is stated.
  double base_per_hardener = 0.0;
  /// Current in the coil of a pair whose field is computed, A; positive repels the magnet.
  double current = 1.0;
};

/// One of the settings as a person gives it.
struct ExportSetting {
  std::string_view name;                    ///< with its unit at the end (units::to_memory): "lead_mm"
  std::string_view text;                    ///< meaning, in a sentence
  double lowest{};                          ///< in that unit
  double highest{};                         ///< in that unit
  double ExportSettings::*value = nullptr;  ///< SI
};

/// All settings of exports.
[[nodiscard]] std::span<const ExportSetting> export_settings() noexcept;

/// One file of an export, complete in memory; the caller writes it.
struct ExportedFile {
  std::string name;  ///< a plain file name, without a folder
  std::string text;  ///< UTF-8, lines end with a newline
  /// Properties of the actuator that the file cannot express, one line each without a full stop. The text of the file
  /// names them too.
  std::vector<std::string> left_out{};
  /// Why the omissions are so large that the file describes another actuator, without a full stop; empty if they are
  /// not.
  std::string too_much{};
};

}  // namespace coilwright::exports
