#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace coilwright::results {

/// The SHA-256 digest of some bytes (FIPS 180-4) in 64 hexadecimal digits: what `sha256sum` prints of them.
[[nodiscard]] std::string sha256(std::string_view bytes);
/// The same of a file, which need not fit into memory. Throws std::runtime_error where it cannot be read.
[[nodiscard]] std::string sha256_of_file(const std::filesystem::path& path);

/// Whether a file that came from elsewhere is a regular file, no link, of so many bytes with that digest. Of anything
/// else nothing is read: a pipe or a device may never end, and a link leads to a file that nobody sent. `take` gets the
/// bytes block by block, before it is known that they are the right ones. Throws std::runtime_error where a file that
/// is there cannot be read.
[[nodiscard]] bool holds_exactly(const std::filesystem::path& path, std::uintmax_t bytes, std::string_view sha256,
                                 const std::function<void(std::string_view block)>& take = {});

}  // namespace coilwright::results
