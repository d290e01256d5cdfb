#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace coilwright::results {

/// The SHA-256 digest of some bytes (FIPS 180-4) in 64 hexadecimal digits: what `sha256sum` prints of them.
[[nodiscard]] std::string sha256(std::string_view bytes);
/// The same of a file, which need not fit into memory. Throws std::runtime_error where it cannot be read.
[[nodiscard]] std::string sha256_of_file(const std::filesystem::path& path);

}  // namespace coilwright::results
