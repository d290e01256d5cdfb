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

// Each costs the system the way through all above it: thousands of them take half a minute, and are a slip.
constexpr std::size_t most_new_folders = 100;
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
    if (absent.size() > most_new_folders)
      throw OutputError(
          path_,
          fmt::format("more than {} folders above it are not there: make them first (mkdir -p)", most_new_folders),
          preparing);
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
  if (has(name)) throw std::invalid_argument(fmt::format("name must not be opened twice; got {}", name));
  std::ostream& stream = files_.emplace_back(path_ / file).stream();
  names_.emplace_back(name);
  return stream;
}

void OutputFolder::write(std::string_view name, std::string_view content) {
  open(name).write(content.data(), static_cast<std::streamsize>(content.size()));
}

void OutputFolder::remove(std::string_view name) {
  outdated_.push_back(path_ / plain_name(name));
}

bool OutputFolder::has(std::string_view name) const {
  return std::find(names_.begin(), names_.end(), name) != names_.end();
}

std::vector<std::pair<std::string, fs::path>> OutputFolder::written() {
  std::vector<std::pair<std::string, fs::path>> out;
  for (std::size_t i = 0; i < files_.size(); ++i) out.emplace_back(names_[i], files_[i].written());
  return out;
}

bool OutputFolder::is_unchanged(std::string_view name) {
  const auto place = std::find(names_.begin(), names_.end(), name);
  if (place == names_.end()) return false;
  OutputFile& file = files_[static_cast<std::size_t>(place - names_.begin())];
  std::error_code none;
  return fs::is_regular_file(file.path(), none) && !file.would_change();
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
  for (std::size_t i = 0; i < files_.size(); ++i) {
    files_[i].close();
    if (names_[i] != key) files.push_back(&files_[i]);
  }
  for (std::size_t i = 0; i < files_.size(); ++i)
    if (names_[i] == key) files.push_back(&files_[i]);
  made_.clear();  // from here on there is something in them
  if (!files.empty()) files.back()->withdraw();
  for (const fs::path& file : outdated_) {
    if (has(file.filename().string())) continue;
    std::error_code error;
    fs::remove(file, error);
    if (error) throw OutputError(file, error.message(), OutputError::Stage::writing);
  }
  for (auto file = files.rbegin(); file != files.rend(); ++file) (*file)->withdraw();
  for (OutputFile* file : files) file->commit();
  wait_for_names_in(path_);
  files_.clear();
  names_.clear();
  outdated_.clear();
}

void OutputFolder::remove_made_folders() noexcept {
  std::error_code ignored;
  for (auto each = made_.rbegin(); each != made_.rend(); ++each) fs::remove(*each, ignored);
  made_.clear();
}

}  // namespace coilwright::text
