#pragma once

#include <filesystem>
#include <fstream>
#include <ostream>

namespace coilwright::text {

/// Opens a file of any length for reading byte by byte. A read error throws std::ios_base::failure and does not count
/// as the end of the file. Throws InputError if the file cannot be opened.
[[nodiscard]] std::ifstream opened(const std::filesystem::path& path);

/// Copies the rest of a file. Throws InputError, which calls it `path`, if it cannot be read to its end.
void copy_rest(std::ifstream& from, const std::filesystem::path& path, std::ostream& to);

}  // namespace coilwright::text
