#pragma once

#include <filesystem>

#include "coilwright/sizing/study.hpp"

namespace coilwright::formats {

/// Reads a study (`"format": "study/1"`) and the actuator it names, whose path counts from the study's folder. Keys are
/// in docs/formats.md. Throws InputError, also for what contradicts itself: a bound that crosses another, a limit that
/// no value can meet together with another one, a current that is both fixed and varied.
[[nodiscard]] sizing::Study read_study(const std::filesystem::path& path);

}  // namespace coilwright::formats
