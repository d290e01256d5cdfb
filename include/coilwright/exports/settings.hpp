#pragma once

#include <span>
#include <string_view>

namespace coilwright::exports {

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

}  // namespace coilwright::exports
