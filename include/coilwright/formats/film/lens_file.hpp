#pragma once

#include <filesystem>

#include "coilwright/text/json/json.hpp"
#include "coilwright/video/vision.hpp"

namespace coilwright::formats {

/// Reads a lens/1 file. Throws InputError.
[[nodiscard]] video::Lens read_lens(const std::filesystem::path& path);

/// The content of a lens/1 file.
[[nodiscard]] text::Json to_json(const video::CalibratedLens& lens);

}  // namespace coilwright::formats
