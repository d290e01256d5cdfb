#pragma once

#include <span>

#include "coilwright/text/packed_file.hpp"

namespace coilwright::exports {

/// What of exported files is the same for every actuator, in its own language: src/exports/assets.
[[nodiscard]] std::span<const text::PackedFile> assets();

}  // namespace coilwright::exports
