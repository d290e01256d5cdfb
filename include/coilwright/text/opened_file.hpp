#pragma once

#include <filesystem>
#include <fstream>
#include <ostream>

namespace coilwright::text {

/// A file opened to be read byte for byte, however long it is; reading that fails throws std::ios_base::failure, and is
/// no end of the file. Throws InputError where it cannot be opened.
[[nodiscard]] std::ifstream opened(const std::filesystem::path& path);

/// Copies what is left of a file. Throws InputError, which calls it `path`, where it cannot be read to its end.
void copy_rest(std::ifstream& from, const std::filesystem::path& path, std::ostream& to);

}  // namespace coilwright::text
