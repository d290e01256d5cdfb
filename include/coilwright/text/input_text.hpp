#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace coilwright::text {

/// The text of a file, and the name by which errors call it.
struct InputText {
  std::string file;  ///< the path as it was given; "standard input" for "-"
  std::string text;
};

/// Reads a whole file, or standard input if the path is "-". Throws InputError if it is no regular file, has more than
/// `size_limit` bytes or cannot be read.
[[nodiscard]] InputText read_text(const std::filesystem::path& path, std::size_t size_limit);

}  // namespace coilwright::text
