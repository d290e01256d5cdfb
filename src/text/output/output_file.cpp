#include "coilwright/text/output/output_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <streambuf>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "coilwright/text/one_line.hpp"
#include "coilwright/text/opened_file.hpp"
#include "coilwright/text/output/plain_output.hpp"
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

// Made by this process, so that a link that stands there is not followed, and locked while it lives; -1 where it cannot
// be made.
int made_part(const fs::path& path) {
  while (true) {
    const int part = ::open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (part < 0) return part;
    struct stat status {};
    static_cast<void>(::flock(part, LOCK_EX));
    if (fstat(part, &status) != 0 || status.st_nlink > 0) return part;
    ::close(part);  // another process took it for one that was left, before it was locked
  }
}

// A file that has no name, and so cannot be left; -1 where it cannot be made.
int made_unnamed() {
  std::string name = (fs::temp_directory_path() / "coilwright-XXXXXX").string();
  const int file = mkostemp(name.data(), O_CLOEXEC);
  if (file >= 0) ::unlink(name.c_str());
  return file;
}

}  // namespace

void remove_left_parts(const fs::path& file) {
  const std::string beginning = fmt::format(".{}.part-", file.filename().string());
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  std::vector<fs::path> parts;
  std::error_code error;
  for (fs::directory_iterator each(folder, error), end; !error && each != end; each.increment(error)) {
    const std::string name = each->path().filename().string();
    if (name.starts_with(beginning) && std::isdigit(static_cast<unsigned char>(name.c_str()[beginning.size()])) != 0)
      parts.push_back(each->path());
  }
  for (const fs::path& path : parts) {
    const int part = ::open(path.c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (part < 0) continue;
    if (::flock(part, LOCK_EX | LOCK_NB) == 0) fs::remove(path, error);
    ::close(part);
  }
}

OutputError::OutputError(const fs::path& path, const std::string& reason, Stage stage)
    : std::runtime_error(text::one_line(path.string(), 600) + ": cannot be written: " + reason), stage_(stage) {}

// A buffer before a file that says why the system refused: std::ofstream only knows that it did.
class OutputFile::Sink : private std::streambuf {
 public:
  Sink(fs::path target, int file) : target_(std::move(target)), file_(file), stream_(this) {
    if (file_ < 0) refuse(OutputError::Stage::preparing);
    setp(buffer_.data(), buffer_.data() + buffer_.size());
    // Rethrows what is thrown below: of a stream that is inserted as a whole only with failbit.
    stream_.exceptions(std::ios::badbit | std::ios::failbit);
  }
  ~Sink() override { ::close(file_); }

  [[nodiscard]] std::ostream& stream() noexcept { return stream_; }

  void finish() {
    sync();
    if (on_disk_) return;
    // Some file systems and pipes know of nothing to wait for.
    if (::fsync(file_) != 0 && errno != EINVAL) refuse(OutputError::Stage::writing);
    on_disk_ = true;
  }

  // Complete before the first byte is out, as a file is before it has its name.
  void copy_to_standard_output() {
    sync();
    ssize_t count = ::lseek(file_, 0, SEEK_SET);
    // Elsewhere than on a terminal the bytes are those of a file.
    std::cout.flush();
    std::ostream out(::isatty(STDOUT_FILENO) == 1 ? std::cout.rdbuf() : PlainOutput::past(std::cout));
    while (count >= 0 && (count = ::read(file_, buffer_.data(), buffer_.size())) > 0) out.write(buffer_.data(), count);
    if (count < 0) refuse(OutputError::Stage::writing);
    out.flush();
    if (!out || !std::cout)
      throw OutputError(standard_stream, "standard output does not take it", OutputError::Stage::writing);
  }

 protected:
  int_type overflow(int_type c) override {
    sync();
    if (!traits_type::eq_int_type(c, traits_type::eof())) sputc(traits_type::to_char_type(c));
    return traits_type::not_eof(c);
  }
  int sync() override {
    for (const char* next = pbase(); next != pptr(); on_disk_ = false) {
      const ssize_t count = ::write(file_, next, static_cast<std::size_t>(pptr() - next));
      if (count < 0 && errno != EINTR) refuse(OutputError::Stage::writing);
      next += std::max<ssize_t>(count, 0);
    }
    setp(buffer_.data(), buffer_.data() + buffer_.size());
    return 0;
  }

 private:
  [[noreturn]] void refuse(OutputError::Stage stage) const { throw OutputError(target_, reason_of(errno), stage); }

  fs::path target_;
  int file_;
  bool on_disk_{false};
  std::array<char, 8192> buffer_{};
  std::ostream stream_;
};

OutputFile::OutputFile(fs::path path) : path_(resolved(path)) {
  if (path_ == standard_stream) {
    sink_ = std::make_unique<Sink>(fs::temp_directory_path(), made_unnamed());
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
  remove_left_parts(path_);
  sibling_ = path_.parent_path() / fmt::format(".{}.part-{}", path_.filename().string(), getpid());
  sink_ = std::make_unique<Sink>(path, made_part(sibling_));
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

const fs::path& OutputFile::written() {
  close();
  return sibling_;
}

bool OutputFile::would_change() {
  close();
  if (path_ == standard_stream) return false;
  std::error_code none;  // not there, or not to be read: nothing is known of it, and commit() says what is wrong
  if (!fs::is_regular_file(path_, none)) return false;
  std::ifstream there = opened(path_);
  std::ifstream mine = opened(sibling_);
  using Bytes = std::istreambuf_iterator<char>;
  return !std::equal(Bytes(there), Bytes(), Bytes(mine), Bytes());
}

bool OutputFile::would_replace_other_kind(std::string_view mark) {
  if (!would_change()) return false;
  std::ifstream there = opened(path_);
  std::ifstream mine = opened(sibling_);
  std::string beginning;
  for (char next{}; !beginning.ends_with(mark) && mine.get(next);) beginning += next;
  std::string present(beginning.size(), '\0');
  there.read(present.data(), static_cast<std::streamsize>(present.size()));
  present.resize(static_cast<std::size_t>(there.gcount()));
  return !present.empty() && present != beginning;
}

void OutputFile::withdraw() {
  close();
  std::error_code error;
  if (path_ != standard_stream) fs::remove(path_, error);
  if (error) throw OutputError(path_, error.message(), OutputError::Stage::writing);
}

void OutputFile::commit() {
  if (path_ == standard_stream) return sink_->copy_to_standard_output();
  close();
  std::error_code error;
  fs::rename(sibling_, path_, error);
  if (error) throw OutputError(path_, error.message(), OutputError::Stage::writing);
  committed_ = true;
}

}  // namespace coilwright::text
