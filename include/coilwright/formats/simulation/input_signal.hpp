#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

namespace coilwright::formats {

/// What an input column commands.
enum class InputKind { current, voltage, torque };

/// Whom the columns of an input command: `current_A` all coils alike, `current1_A, current2_A, ...` one each.
enum class InputAddressing { common, each };

/// A commanded input over time, held between samples (zero order).
struct InputSignal {
  InputKind kind{};
  InputAddressing addressing{};
  std::vector<double> times{};                ///< s, strictly increasing, at least one
  std::vector<std::vector<double>> values{};  ///< A, V or N m: one vector a coil or joint (one in all when common)
};

/// Reads the time and input columns of a transient run of measured-data/1: `time_s` and one of `current_A`,
/// `current1_A,...`, `voltage_V`, `torque1_Nm,...`. Measured columns (`bending_angle_deg`, `theta1_deg`,
/// `omega1_rad_s`, ...) may stand beside them and are not used. Throws InputError.
[[nodiscard]] InputSignal read_input_signal(const std::filesystem::path& path);

/// The same for a text in memory; `file` is the name its errors carry.
[[nodiscard]] InputSignal parse_input_signal(std::string_view text, std::string_view file);

}  // namespace coilwright::formats
