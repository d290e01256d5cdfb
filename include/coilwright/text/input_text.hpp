#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace coilwright::text {

/// What a file held when it was read, and the name that errors give it.
struct InputText {
  std::string file;  ///< the path as it was given; "standard input" for "-"
  std::string text;
};

/// Reads a whole file, or standard input where the path is "-". Throws InputError where it is no regular file, has more
/// than `size_limit` bytes or cannot be read.
[[nodiscard]] InputText read_text(const std::filesystem::path& path, std::size_t size_limit);

}  // namespace coilwright::text
