#pragma once

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <string_view>
#include <system_error>

namespace attribution {

/// A temporary folder for one set, which is removed in any case.
class TemporarySetFolder {
 public:
  TemporarySetFolder(std::string_view benchmark, int number)
      : path_(std::filesystem::temp_directory_path() /
              fmt::format("coilwright_{}_{}_{}", benchmark, getpid(), number)) {
    std::filesystem::create_directories(path_);
  }
  ~TemporarySetFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporarySetFolder(const TemporarySetFolder&) = delete;
  TemporarySetFolder& operator=(const TemporarySetFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace attribution
