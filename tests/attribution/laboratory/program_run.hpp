#pragma once

#include <filesystem>
#include <string>

namespace attribution::laboratory {

[[nodiscard]] std::string text_of(const std::filesystem::path& file);

/// Runs a command of the shell and returns what it prints, by way of a file. Throws std::runtime_error with those words
/// where it fails.
std::string words_of(const std::string& command, const std::filesystem::path& words);

}  // namespace attribution::laboratory
