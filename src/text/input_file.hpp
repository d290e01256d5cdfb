#pragma once

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace coilwright::text {

/// The name that stands for standard input or output.
inline constexpr std::string_view standard_stream = "-";

/// An input file opened for reading once, from the front: "-" is standard input, which errors call by that name.
class InputFile {
 public:
  /// Throws InputError when `path` is not a regular file, is larger than `size_limit` bytes or cannot be opened.
  InputFile(const std::filesystem::path& path, std::size_t size_limit);

  /// Fills `buffer` from the file and returns the part that was filled: all of it, but for the end of the file.
  /// Throws InputError when reading fails, or when the file has grown beyond the limit meanwhile.
  [[nodiscard]] std::span<char> read(std::span<char> buffer);

  [[nodiscard]] const std::string& name() const noexcept { return name_; }

 private:
  struct Close {
    void operator()(std::FILE* file) const noexcept {
      if (file != stdin) std::fclose(file);  // a second reader finds it at its end
    }
  };

  std::string name_;
  std::size_t size_limit_;  // bytes
  std::size_t bytes_read_{0};
  std::unique_ptr<std::FILE, Close> file_;
};

}  // namespace coilwright::text
