#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace coilwright::results {

/// The SHA-256 digest of some bytes (FIPS 180-4) in 64 hexadecimal digits, as `sha256sum` prints it.
[[nodiscard]] std::string sha256(std::string_view bytes);
/// The SHA-256 digest of a file, which need not fit into memory. Throws std::runtime_error if it cannot be read.
[[nodiscard]] std::string sha256_of_file(const std::filesystem::path& path);

/// Whether a file of foreign origin is a regular file, no link, of `bytes` bytes with that digest. Nothing is read of
/// anything else, because a pipe or a device may never end and a link leads to a file that nobody sent. `take` gets the
/// bytes block by block, before they are known to be right. Throws std::runtime_error if an existing file cannot be
/// read.
[[nodiscard]] bool holds_exactly(const std::filesystem::path& path, std::uintmax_t bytes, std::string_view sha256,
                                 const std::function<void(std::string_view block)>& take = {});

}  // namespace coilwright::results
