#include "coilwright/text/output/output_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "coilwright/text/output/file_name.hpp"

namespace coilwright::text {
namespace {

namespace fs = std::filesystem;

constexpr auto preparing = OutputError::Stage::preparing;

fs::path plain_name(std::string_view name) {
  if (const auto rule = fault_of_file_name(name))
    throw std::invalid_argument(fmt::format("name {}; got {}", *rule, name));
  return name;
}

// Until the names of its files are on the disk. Not every file system has something to wait for.
void wait_for_names_in(const fs::path& folder) {
  const int names = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (names < 0) return;
  ::fsync(names);
  ::close(names);
}

}  // namespace

OutputFolder::OutputFolder(fs::path path) : path_(std::move(path)) {
  if (path_.empty()) throw OutputError(path_, "the name of the folder must not be empty", preparing);
  if (path_ == "-") throw OutputError(path_, "it must be a folder, and - is standard output", preparing);
  if (!path_.has_filename()) path_ = path_.parent_path();  // "out/" is "out"
  std::error_code error;
  std::vector<fs::path> absent;
  for (fs::path each = path_; !each.empty() && !fs::exists(fs::symlink_status(each, error));
       each = each.parent_path()) {
    absent.push_back(each);
  }
  std::reverse(absent.begin(), absent.end());
  for (const fs::path& each : absent) {
    if (fs::create_directory(each, error)) made_.push_back(each);
    if (error) {
      remove_made_folders();
      throw OutputError(path_, error.message(), preparing);
    }
  }
  try {
    const OutputFile trial(path_ / "trial");
  } catch (const OutputError& refusal) {
    remove_made_folders();
    // The user named the folder, not the trial.
    const std::string_view text = refusal.what();
    throw OutputError(path_, std::string(text.substr(text.rfind(": ") + 2)), preparing);
  }
}

OutputFolder::~OutputFolder() {
  files_.clear();
  remove_made_folders();
}

std::ostream& OutputFolder::open(std::string_view name) {
  const fs::path file = plain_name(name);
  const bool open_already =
      std::any_of(files_.begin(), files_.end(), [&](const OutputFile& each) { return each.path() == path_ / file; });
  if (open_already) throw std::invalid_argument(fmt::format("name must not be opened twice; got {}", name));
  return files_.emplace_back(path_ / file).stream();
}

void OutputFolder::write(std::string_view name, std::string_view content) {
  open(name).write(content.data(), static_cast<std::streamsize>(content.size()));
}

void OutputFolder::remove(std::string_view name) {
  outdated_.push_back(path_ / plain_name(name));
}

std::optional<fs::path> OutputFolder::first_change() {
  for (OutputFile& file : files_)
    if (file.would_change()) return file.path();
  return std::nullopt;
}

void OutputFolder::lock() {
  if (!lock_) lock_.emplace(path_);
}

void OutputFolder::commit(std::string_view key) {
  lock();
  std::vector<OutputFile*> files;
  for (OutputFile& file : files_) {
    file.close();
    files.push_back(&file);
  }
  // Not of std::ranges, nor std::views::reverse: Clang 14 does not take them from this standard library.
  std::stable_partition(files.begin(), files.end(),
                        [&](const OutputFile* file) { return file->path().filename() != key; });
  made_.clear();  // from here on there is something in them
  for (auto file = files.rbegin(); file != files.rend(); ++file) (*file)->withdraw();
  for (const fs::path& file : outdated_) {
    std::error_code error;
    fs::remove(file, error);
    if (error) throw OutputError(file, error.message(), OutputError::Stage::writing);
  }
  for (OutputFile* file : files) file->commit();
  wait_for_names_in(path_);
  files_.clear();
}

void OutputFolder::remove_made_folders() noexcept {
  std::error_code ignored;
  for (auto each = made_.rbegin(); each != made_.rend(); ++each) fs::remove(*each, ignored);
  made_.clear();
}

}  // namespace coilwright::text
