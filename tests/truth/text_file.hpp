#pragma once

#include <filesystem>
#include <string>

namespace truth {

/// Throws std::runtime_error if the file cannot be written.
void write_text(const std::filesystem::path& file, const std::string& text);

}  // namespace truth
