#include "coilwright/text/output/output_file.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string_view>
#include <system_error>
#include <utility>

#include "coilwright/text/one_line.hpp"
#include "text/input_file.hpp"

namespace coilwright::text {
namespace {

namespace fs = std::filesystem;

std::string reason_of(int error) {
  return std::generic_category().message(error == 0 ? EIO : error);
}

// A link is followed: the file it leads to is replaced, and the link stays.
fs::path resolved(const fs::path& path) {
  std::error_code error;
  if (!fs::is_symlink(fs::symlink_status(path, error))) return path;
  const fs::path target = fs::weakly_canonical(path, error);
  return error ? path : target;
}

}  // namespace

OutputError::OutputError(const fs::path& path, const std::string& reason, Stage stage)
    : std::runtime_error(text::one_line(path.string(), 600) + ": cannot be written: " + reason), stage_(stage) {}

// A file buffer that says why the system refused: std::ofstream only knows that it did.
class OutputFile::Sink : private std::filebuf {
 public:
  Sink(const fs::path& target, const fs::path& sibling) : target_(target), stream_(this) {
    errno = 0;
    if (open(sibling, std::ios::out | std::ios::binary | std::ios::trunc) == nullptr)
      refuse(OutputError::Stage::preparing);
    stream_.exceptions(std::ios::badbit);  // rethrows what is thrown below
  }

  [[nodiscard]] std::ostream& stream() noexcept { return stream_; }

  void finish() {
    if (!is_open()) return;
    errno = 0;
    if (close() == nullptr) refuse(OutputError::Stage::writing);
  }

 protected:
  int_type overflow(int_type c) override {
    errno = 0;
    const int_type result = std::filebuf::overflow(c);
    if (traits_type::eq_int_type(result, traits_type::eof())) refuse(OutputError::Stage::writing);
    return result;
  }
  std::streamsize xsputn(const char* text, std::streamsize size) override {
    errno = 0;
    const std::streamsize written = std::filebuf::xsputn(text, size);
    if (written != size) refuse(OutputError::Stage::writing);
    return written;
  }
  int sync() override {
    errno = 0;
    if (std::filebuf::sync() != 0) refuse(OutputError::Stage::writing);
    return 0;
  }

 private:
  [[noreturn]] void refuse(OutputError::Stage stage) const { throw OutputError(target_, reason_of(errno), stage); }

  fs::path target_;
  std::ostream stream_;
};

namespace {

// Complete before the first byte is out, as a file is before it has its name.
void copy_to_standard_output(const fs::path& file) {
  std::cout << std::ifstream(file, std::ios::binary).rdbuf() << std::flush;
  if (!std::cout) throw OutputError(standard_stream, "standard output does not take it", OutputError::Stage::writing);
}

}  // namespace

OutputFile::OutputFile(fs::path path) : path_(resolved(path)) {
  if (path_ == standard_stream) {
    sibling_ = fs::temp_directory_path() / fmt::format("coilwright-{}.part", getpid());
    sink_ = std::make_unique<Sink>(sibling_, sibling_);
    return;
  }
  const auto refuse = [&](const std::string& reason) {
    throw OutputError(path, reason, OutputError::Stage::preparing);
  };
  if (!path_.has_filename()) refuse("it must be a file name");
  std::error_code error;
  const fs::file_status status = fs::status(path_, error);
  if (fs::is_directory(status)) refuse(reason_of(EISDIR));
  // Renaming onto a device would replace it.
  if (fs::exists(status) && !fs::is_regular_file(status)) refuse("it is a device or a pipe");
  sibling_ = path_.parent_path() / fmt::format(".{}.part-{}", path_.filename().string(), getpid());
  sink_ = std::make_unique<Sink>(path, sibling_);
}

OutputFile::~OutputFile() {
  if (committed_) return;
  sink_.reset();
  std::error_code ignored;
  fs::remove(sibling_, ignored);
}

std::ostream& OutputFile::stream() noexcept {
  return sink_->stream();
}

void OutputFile::close() {
  sink_->finish();
}

bool OutputFile::would_change() {
  close();
  if (path_ == standard_stream) return false;
  std::error_code none;  // not there, or not to be read: nothing is known of it, and commit() says what is wrong
  if (!fs::is_regular_file(path_, none)) return false;
  std::ifstream there(path_, std::ios::binary);
  std::ifstream mine(sibling_, std::ios::binary);
  using Bytes = std::istreambuf_iterator<char>;
  return !std::equal(Bytes(there), Bytes(), Bytes(mine), Bytes());
}

bool OutputFile::would_replace_other_kind(std::string_view mark) {
  if (!would_change()) return false;
  std::ifstream there(path_, std::ios::binary);
  std::ifstream mine(sibling_, std::ios::binary);
  std::string beginning;
  for (char next{}; !beginning.ends_with(mark) && mine.get(next);) beginning += next;
  std::string present(beginning.size(), '\0');
  there.read(present.data(), static_cast<std::streamsize>(present.size()));
  present.resize(static_cast<std::size_t>(there.gcount()));
  return !present.empty() && present != beginning;
}

void OutputFile::commit() {
  close();
  if (path_ == standard_stream) {
    copy_to_standard_output(sibling_);
    return;  // the sibling goes with this object
  }
  std::error_code error;
  fs::rename(sibling_, path_, error);
  if (error) throw OutputError(path_, error.message(), OutputError::Stage::writing);
  committed_ = true;
}

}  // namespace coilwright::text
