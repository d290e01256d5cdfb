#pragma once

#include <deque>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "coilwright/text/output/folder_lock.hpp"
#include "coilwright/text/output/output_file.hpp"

namespace coilwright::text {

/// A folder of results that appear together. Files are written beside their final names and get them at commit(), each
/// in one step, after all of them are complete and on the disk and those that they replace are gone; other files in the
/// folder stay. A program that is killed meanwhile leaves files of one answer only. Without commit() nothing is left:
/// no file, and none of the folders that had to be made.
class OutputFolder {
 public:
  /// Makes the folder if it is not there and tries that it can be written. Throws OutputError (preparing).
  explicit OutputFolder(std::filesystem::path path);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// A file of the folder to stream into; the stream lives until commit(). Throws OutputError (writing) when it cannot
  /// be opened, std::invalid_argument when `name` is not a plain file name or was opened before.
  [[nodiscard]] std::ostream& open(std::string_view name);
  /// A file with this content.
  void write(std::string_view name, std::string_view content);
  /// Removes at commit() what an earlier run may have left under this name, so that it is not taken for a result of
  /// this one.
  void remove(std::string_view name);
  /// Whether a file of this name was opened so far.
  [[nodiscard]] bool has(std::string_view name) const;
  /// Each file opened so far, complete, in that order: its name, and the file that has its bytes until commit().
  /// Nothing may be written to them any more. Throws OutputError (writing).
  [[nodiscard]] std::vector<std::pair<std::string, std::filesystem::path>> written();
  /// Whether that file is in the folder already, with the content that was written to it; nothing may be written to it
  /// any more. Throws OutputError (writing).
  [[nodiscard]] bool is_unchanged(std::string_view name);
  /// The first of the files opened so far whose name another content has in the folder, which commit() would lose;
  /// nothing where none has. Nothing may be written to them any more. Throws OutputError (writing).
  [[nodiscard]] std::optional<std::filesystem::path> first_change();
  /// Keeps other processes from writing to the folder as long as this object lives. Throws OutputError (preparing)
  /// where one does; says in a line on standard error where the file system has no locks.
  void lock();
  /// Locks the folder and gives all files their names. The one called `key`, by which a reader knows the folder, goes
  /// first where it is replaced, and comes last: where it is there, all are. Then goes what remove() names, in that
  /// order. Throws OutputError (writing); if a file is incomplete, none of them changes.
  void commit(std::string_view key = {});

  [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }

 private:
  void remove_made_folders() noexcept;

  std::filesystem::path path_;
  std::vector<std::filesystem::path> made_;  // outermost first
  std::vector<std::filesystem::path> outdated_;
  std::optional<FolderLock> lock_;
  std::deque<OutputFile> files_;    // a deque: a stream's address must not change
  std::vector<std::string> names_;  // of each, which may be a link to its path
};

}  // namespace coilwright::text
