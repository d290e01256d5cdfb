#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "coilwright/sizing/study.hpp"

namespace coilwright::formats {

/// Reads a study (`"format": "study/1"`) and the actuator it names, whose path counts from the study's folder. Keys are
/// in docs/formats.md. Throws InputError, also for what contradicts itself: a bound that crosses another, a limit that
/// no value can meet together with another one, a current that is both fixed and varied.
[[nodiscard]] sizing::Study read_study(const std::filesystem::path& path);

/// The same for a text in memory; `file` is the name its errors carry, and the actuator's path counts from its folder.
[[nodiscard]] sizing::Study parse_study(std::string_view text, std::string file);

}  // namespace coilwright::formats
