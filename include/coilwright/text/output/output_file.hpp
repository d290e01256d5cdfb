#pragma once

#include <filesystem>
#include <memory>
#include <ostream>
#include <stdexcept>
#include <string>
#include <string_view>

namespace coilwright::text {

/// An output that cannot be written: `out/x: cannot be written: Permission denied`, one line.
class OutputError : public std::runtime_error {
 public:
  /// When it came out: before any work (the user named a place that cannot be used), or with the results in hand.
  enum class Stage { preparing, writing };

  /// One line from the path and the reason.
  OutputError(const std::filesystem::path& path, const std::string& reason, Stage stage);
  [[nodiscard]] Stage stage() const noexcept { return stage_; }

 private:
  Stage stage_;
};

/// Removes the unfinished siblings of a file (`.NAME.part-PID`) that processes left which were killed. Those of a
/// process that lives stay, and all of them where the file system has no locks, by which this is known.
void remove_left_parts(const std::filesystem::path& file);

/// A file that appears under its name only when it is complete. Until commit() it grows as a hidden sibling, and what
/// stood under the name stays as it was; without commit() the sibling is removed. Memory is bounded by the stream's
/// buffer, however long the file. The name "-" is standard output, which gets all of it at commit() from a file without
/// a name.
class OutputFile {
 public:
  /// Opens the sibling, so that a place that cannot be written is known before the work, and removes those that were
  /// left. Throws OutputError (preparing).
  explicit OutputFile(std::filesystem::path path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Writing to it throws OutputError (writing) as soon as the system refuses, say because the disk is full.
  [[nodiscard]] std::ostream& stream() noexcept;
  [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }

  /// Writes out what is buffered and waits until all of it is on the disk. Throws OutputError (writing).
  void close();
  /// Closes, and says which file has the bytes until commit(); none for standard output. Throws as close().
  [[nodiscard]] const std::filesystem::path& written();
  /// Closes, and tells whether commit() would replace a file of another content. Throws OutputError (writing),
  /// InputError where that file cannot be opened.
  [[nodiscard]] bool would_change();
  /// Closes, and tells whether commit() would replace a file of another kind: one that is not empty and does not begin
  /// as this one does up to the end of the first `mark` (the header of a table: "\n"). Throws OutputError (writing),
  /// InputError where that file cannot be opened.
  [[nodiscard]] bool would_replace_other_kind(std::string_view mark);
  /// Closes, and removes what stands under the name, before other files of the same answer get theirs: a program that
  /// is killed then leaves a gap, and never files of two answers side by side. Throws OutputError (writing).
  void withdraw();
  /// Closes, and gives the file its name in one step, replacing what stood there. Throws OutputError (writing).
  void commit();

 private:
  class Sink;

  std::filesystem::path path_;
  std::filesystem::path sibling_;
  std::unique_ptr<Sink> sink_;
  bool committed_{false};
};

}  // namespace coilwright::text
