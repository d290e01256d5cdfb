#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "coilwright/archive/contents.hpp"
#include "coilwright/archive/row.hpp"

namespace coilwright::archive {

/// Makes the archive of these contents, without a design, replacing what stands under its name. It appears complete or
/// not at all. Throws text::OutputError (preparing), and InputError where a file that is no log of an archive there has
/// the name of one (archive.sqlite-wal).
void create(const std::filesystem::path& path, const Contents& contents);

/// The designs of an archive that were not what was written.
struct Repair {
  std::size_t mended{};                 ///< that are what was written again
  std::vector<std::int64_t> dropped{};  ///< ids of those that were taken out
  std::size_t dropped_choices{};        ///< those under other modelling choices that were taken out
  std::size_t left{};                   ///< that are damaged still, because it was told to stop
  std::int64_t gone{};                  ///< that were written and are not there

  /// How many were mended or taken out.
  [[nodiscard]] std::size_t looked_at() const { return mended + dropped.size() + dropped_choices; }
};

/// Asked before each evaluation, with how many are done of how many: whether the repair goes on.
using KeepsOn = std::function<bool(std::size_t done, std::size_t of)>;

/// The evaluation anew of a design of an archive, with as many numbers as it has columns; nothing where it has none.
using EvaluateAgain = std::function<std::optional<sizing::Evaluation>(const Contents&, const Row&)>;

/// Evaluates the designs of an archive anew that are not what was written. Where the checksum holds with what comes
/// out, the row is what was written, to the last bit, and is mended. Else the damage is in what no evaluation gives
/// (its variables, its time), or the program gives other numbers: it is taken out, and a run that goes on evaluates it,
/// as it does what is gone. Each is on the disk before the next is evaluated. Throws InputError where anything else is
/// damaged, of which nothing can be made again, and text::OutputError (preparing) where it cannot be written.
[[nodiscard]] Repair repair_designs(const std::filesystem::path& path, const EvaluateAgain& again,
                                    const KeepsOn& keeps_on);

/// Writes the designs of one run to an archive. A thread of its own does so, a tenth of a second's designs at a time,
/// and no evaluation waits for the disk: what add() has taken is on the disk at most 0.2 s later, whatever then becomes
/// of the program.
///
/// Where the disk refuses (it is full, another process has locked the archive), designs wait in memory, about a
/// kilobyte each, and are tried again every second, with flush() and at the end.
class Writer {
 public:
  /// Told that the disk refuses, and why, and then that all that waited is written; one line each, on the writer's
  /// thread. May be empty.
  using OnRefusal = std::function<void(const std::string&)>;

  /// Opens an archive that is there and begins a run in it. `max_evaluations` is its budget, if it has one; a lock of
  /// another process is waited for as long as `patience`, and after it was in vain a tenth of that. Throws InputError
  /// where the file is no archive, text::OutputError (preparing) where it cannot be written.
  Writer(const std::filesystem::path& path, std::optional<std::size_t> max_evaluations, OnRefusal on_refusal,
         std::chrono::milliseconds patience = std::chrono::seconds(10));
  /// Writes what it has taken, as far as the disk lets it. A run that was not ended stays so.
  ~Writer();
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  /// Takes a design to be written; its id and run are the writer's to give. From any thread; returns at once, unless
  /// some thousand designs wait for a disk that takes them.
  void add(Row row);

  /// Returns when all that was taken is on the disk, or has been refused once more. Then failure() is complete.
  void flush();

  /// Writes the order of the search: of each pair the second is the number of the design with the first as its id. All
  /// other designs lose theirs. After flush() only, and from one thread; nothing is done where there is a failure().
  void number(const std::vector<std::pair<std::int64_t, std::size_t>>& numbers);

  /// Ends the run with its stop reason and counts; the id and the times are the writer's to give. As number().
  void end(const Run& run);

  /// Why designs are not on the disk, with their number; nothing where it took all it was asked to.
  [[nodiscard]] std::optional<std::string> failure() const;

 private:
  class Thread;
  std::unique_ptr<Thread> thread_;
};

}  // namespace coilwright::archive
