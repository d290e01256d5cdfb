#pragma once

#include <filesystem>
#include <memory>
#include <ostream>
#include <stdexcept>
#include <string>
#include <string_view>

namespace coilwright::text {

/// An error for an output that cannot be written, in one line: `out/x: cannot be written: Permission denied`.
class OutputError : public std::runtime_error {
 public:
  /// The time of the error: before any work (the user named a place that cannot be used), or when the results were
  /// ready.
  enum class Stage { preparing, writing };

  /// Makes one line of the path and the reason.
  OutputError(const std::filesystem::path& path, const std::string& reason, Stage stage);
  [[nodiscard]] Stage stage() const noexcept { return stage_; }

 private:
  Stage stage_;
};

/// Removes the unfinished siblings of a file (`.NAME.part-PID`) that killed processes left. Those of a living process
/// stay; all stay if the file system has no locks by which this is known.
void remove_left_parts(const std::filesystem::path& file);

/// A file that appears under its name only when it is complete. Until commit() it grows as a hidden sibling, and an
/// existing file of that name stays; without commit() the sibling is removed. Memory is bounded by the stream's buffer,
/// however long the file. The name "-" is standard output, which gets everything at commit() from a file without a
/// name.
class OutputFile {
 public:
  /// Opens the sibling, so that a place that cannot be written is known before the work, and removes left ones. Throws
  /// OutputError (preparing).
  explicit OutputFile(std::filesystem::path path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// The stream of the file. Writing throws OutputError (writing) as soon as the system refuses, for example because
  /// the disk is full.
  [[nodiscard]] std::ostream& stream() noexcept;
  [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }

  /// Writes the buffer and waits until everything is on the disk. Throws OutputError (writing).
  void close();
  /// Closes the file and returns the path that has its bytes until commit(); empty for standard output. Throws as
  /// close().
  [[nodiscard]] const std::filesystem::path& written();
  /// Closes the file and returns whether commit() would replace a file of another content. Throws OutputError
  /// (writing), and InputError if that file cannot be opened.
  [[nodiscard]] bool would_change();
  /// Closes the file and returns whether commit() would replace a file of another kind: one that is not empty and does
  /// not begin like this one up to the end of the first `mark` (the header of a table: "\n"). Throws OutputError
  /// (writing), and InputError if that file cannot be opened.
  [[nodiscard]] bool would_replace_other_kind(std::string_view mark);
  /// Closes the file and removes an existing file of its name, before other files of the same answer get theirs. A
  /// program that is killed then leaves a gap, and never files of two answers side by side. Throws OutputError
  /// (writing).
  void withdraw();
  /// Closes the file and gives it its name in one step, replacing an existing one. Throws OutputError (writing).
  void commit();

 private:
  class Sink;

  std::filesystem::path path_;
  std::filesystem::path sibling_;
  std::unique_ptr<Sink> sink_;
  bool committed_{false};
};

}  // namespace coilwright::text
