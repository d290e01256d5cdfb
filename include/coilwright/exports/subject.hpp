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

/// Where an export comes from, as the exported files say it.
struct Origin {
  std::string name;     ///< of the actuator, one line of UTF-8; may be empty
  std::string made_by;  ///< one line of UTF-8: program, version, input file and what was changed of it; may be empty
};

/// An actuator whose geometry is known.
struct DesignSubject {
  Origin origin;
  actuator::Design design;
  actuator::Assembly assembly;                                ///< of `design`
  std::optional<actuator::OperatingPoint> operating_point{};  ///< for which it was sized
};

/// An actuator of which only the model is known, or wanted.
struct ModelSubject {
  Origin origin;
  actuator::Model model;
};

/// What is exported: of a design (actuator/1) or of a lumped model (lumped-model/1).
using Subject = std::variant<DesignSubject, ModelSubject>;

/// What an export may be told beside the actuator. Each kind of export reads those that its row names.
struct ExportSettings {
  /// Of each of the two leads of a coil, m; >= 0. Not part of the winding: resistance and mass of the lead are told
  /// apart from the coil's.
  double lead_length = 0.15;
  /// Silicone that stays in cups, on tools and in the mould's seam, over the silicone in the actuator; >= 0.
  double waste = 0.25;
  /// Mass of part A of the silicone over that of part B; 0: not known, then only the sum of both is told.
  double base_per_hardener = 0.0;
  /// In the coil of a pair whose field is computed, A; positive repels the magnet.
  double current = 1.0;
};

/// One of them as a person gives it.
struct ExportSetting {
  std::string_view name;                    ///< with its unit at the end (units::to_memory): "lead_mm"
  std::string_view text;                    ///< what it is, in a sentence
  double lowest{};                          ///< in that unit
  double highest{};                         ///< in that unit
  double ExportSettings::*value = nullptr;  ///< SI
};

/// All of them.
[[nodiscard]] std::span<const ExportSetting> export_settings() noexcept;

/// One file of an export, complete in memory: the writing is the caller's.
struct ExportedFile {
  std::string name;  ///< a plain file name, without a folder
  std::string text;  ///< UTF-8, lines end with a newline
  /// What of the actuator the file cannot say, one line each without a full stop: the text names it too.
  std::vector<std::string> left_out{};
  /// Why that is so much that the file is of another actuator, without a full stop; empty where it is not.
  std::string too_much{};
};

}  // namespace coilwright::exports
