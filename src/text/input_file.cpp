#include "text/input_file.hpp"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <limits>
#include <system_error>

#include "coilwright/text/input_error.hpp"
#include "coilwright/text/input_text.hpp"
#include "coilwright/text/opened_file.hpp"
#include "coilwright/text/require_readable.hpp"

namespace coilwright::text {
namespace {

namespace fs = std::filesystem;

InputError cannot(std::string_view what, const std::string& name, int error) {
  return InputError(
      {.file = name, .rule = fmt::format("cannot be {}: {}", what, std::generic_category().message(error))});
}

InputError too_large(const std::string& name, std::size_t limit) {
  return InputError({.file = name, .rule = fmt::format("must not be larger than {} MB", limit / 1'000'000)});
}

}  // namespace

InputFile::InputFile(const fs::path& path, std::size_t size_limit) : name_(path.string()), size_limit_(size_limit) {
  if (path == standard_stream) {
    name_ = "standard input";
    file_.reset(stdin);
    return;
  }
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) throw cannot("opened", name_, error ? error.value() : ENOENT);
  if (fs::is_directory(status)) throw InputError({.file = name_, .rule = "must be a file, and is a folder"});
  // A pipe or a device may never end, and opening it may block.
  if (!fs::is_regular_file(status)) {
    throw InputError({.file = name_, .rule = "must be a regular file, and is a device or a pipe"});
  }
  const auto size = fs::file_size(path, error);
  if (error) throw cannot("opened", name_, error.value());
  if (size > size_limit) throw too_large(name_, size_limit);
  file_.reset(std::fopen(name_.c_str(), "rb"));
  if (!file_) throw cannot("opened", name_, errno);
}

std::span<char> InputFile::read(std::span<char> buffer) {
  const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), file_.get());
  if (count < buffer.size() && std::ferror(file_.get()) != 0) throw cannot("read", name_, errno);
  bytes_read_ += count;
  if (bytes_read_ > size_limit_) throw too_large(name_, size_limit_);
  return buffer.first(count);
}

InputText read_text(const std::filesystem::path& path, std::size_t size_limit) {
  InputFile file(path, size_limit);
  InputText read{.file = file.name(), .text = {}};
  constexpr std::size_t block = 1 << 16;
  for (std::size_t filled = 0;; filled = read.text.size()) {
    read.text.resize(filled + block);
    read.text.resize(filled + file.read({read.text.data() + filled, block}).size());
    if (read.text.size() < filled + block) return read;
  }
}

std::ifstream opened(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw cannot("opened", path.string(), errno);
  file.exceptions(std::ios::badbit);
  return file;
}

void copy_rest(std::ifstream& from, const fs::path& path, std::ostream& to) {
  std::array<char, 1 << 16> block{};
  const auto next = [&] {
    try {
      from.read(block.data(), block.size());
    } catch (const std::ios_base::failure&) {
      throw cannot("read", path.string(), errno);
    }
    return from.gcount();
  };
  while (const std::streamsize count = next()) to.write(block.data(), count);
}

void require_readable(const fs::path& path) {
  InputFile file(path, std::numeric_limits<std::size_t>::max());
  char first{};
  if (file.read({&first, 1}).empty()) throw InputError({.file = file.name(), .rule = "must not be empty"});
}

}  // namespace coilwright::text
