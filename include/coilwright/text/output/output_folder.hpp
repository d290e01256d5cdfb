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
/// folder stay. A program that is killed during this leaves files of one answer only. Without commit() nothing remains,
/// neither files nor the folders that had to be made.
class OutputFolder {
 public:
  /// Makes the folder if it does not exist, and tests that it can be written. Throws OutputError (preparing).
  explicit OutputFolder(std::filesystem::path path);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// Opens a file of the folder; the stream lives until commit(). Throws OutputError (writing) if it cannot be opened,
  /// std::invalid_argument if `name` is not a plain file name or was opened before.
  [[nodiscard]] std::ostream& open(std::string_view name);
  /// Writes a file with this content.
  void write(std::string_view name, std::string_view content);
  /// Removes at commit() an earlier run's file of this name, so that it is not taken for a result of this one.
  void remove(std::string_view name);
  /// Whether a file of this name has been opened.
  [[nodiscard]] bool has(std::string_view name) const;
  /// The opened files, complete, in that order: the name of each, and the file that has its bytes until commit(). They
  /// can no longer be written to. Throws OutputError (writing).
  [[nodiscard]] std::vector<std::pair<std::string, std::filesystem::path>> written();
  /// Whether that file is in the folder already with the same content; it can no longer be written to. Throws
  /// OutputError (writing).
  [[nodiscard]] bool is_unchanged(std::string_view name);
  /// The first of the opened files that would replace another content in the folder at commit(); absent if there is
  /// none. The files can no longer be written to. Throws OutputError (writing).
  [[nodiscard]] std::optional<std::filesystem::path> first_change();
  /// Keeps other processes from writing to the folder as long as this object lives. Throws OutputError (preparing) if
  /// one does so; if the file system has no locks, a line on standard error says so.
  void lock();
  /// Locks the folder and gives all files their names. An existing file called `key`, by which a reader knows the
  /// folder, is removed first, and the new one comes last: if it exists, all do. Then the files named by remove() are
  /// deleted, in that order. Throws OutputError (writing); if a file is incomplete, none of them changes.
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
