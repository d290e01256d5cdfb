#include "coilwright/exports/settings.hpp"

#include <array>

namespace coilwright::exports {
namespace {

constexpr std::array setting_table = {
    ExportSetting{.name = "lead_mm",
                  .text = "Length of each of the two leads of a coil, mm (default 150)",
                  .lowest = 0.0,
                  .highest = 10'000.0,
                  .value = &ExportSettings::lead_length},
    ExportSetting{.name = "waste",
                  .text = "Silicone that stays in cups and on tools, over the silicone in the actuator (default 0.25)",
                  .lowest = 0.0,
                  .highest = 10.0,
                  .value = &ExportSettings::waste},
    ExportSetting{.name = "base_per_hardener",
                  .text = "Mass of part A of the silicone over that of part B, by its data sheet (default: not known)",
                  .lowest = 0.01,
                  .highest = 1000.0,
                  .value = &ExportSettings::base_per_hardener},
    ExportSetting{
        .name = "current_A",
        .text = "Current in the coil of the pair whose field is computed, A; positive repels the magnet (default 1)",
        .lowest = -1000.0,
        .highest = 1000.0,
        .value = &ExportSettings::current},
};

}  // namespace

std::span<const ExportSetting> export_settings() noexcept {
  return setting_table;
}

}  // namespace coilwright::exports
