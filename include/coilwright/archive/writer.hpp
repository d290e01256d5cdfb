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

/// Creates the archive of these contents without a design, and replaces what has its name. It appears complete or not
/// at all. Throws text::OutputError (preparing), and InputError if another file has the name of one of its logs
/// (archive.sqlite-wal).
void create(const std::filesystem::path& path, const Contents& contents);

/// The result of a repair: the designs of an archive that had been changed.
struct Repair {
  std::size_t mended{};                 ///< designs that are as written again
  std::vector<std::int64_t> dropped{};  ///< ids of those that were taken out
  std::size_t dropped_choices{};        ///< designs under other modelling choices that were taken out
  std::size_t left{};                   ///< designs that are still damaged, because the repair was stopped
  std::int64_t gone{};                  ///< designs that were written and are missing

  /// Number of designs that were mended or taken out.
  [[nodiscard]] std::size_t looked_at() const { return mended + dropped.size() + dropped_choices; }
};

/// Called before each evaluation with the numbers of finished and of all designs; returns whether the repair continues.
using KeepsOn = std::function<bool(std::size_t done, std::size_t of)>;

/// Evaluates a design of an archive again, with as many numbers as the archive has columns; absent if it has no
/// evaluation.
using EvaluateAgain = std::function<std::optional<sizing::Evaluation>(const Contents&, const Row&)>;

/// Evaluates again the designs of an archive that were changed. If the checksum holds with the numbers that come out,
/// the row is mended, which restores it to the last bit. Otherwise the damage is in something that no evaluation gives
/// (its variables, its time), or the program gives other numbers: the row is taken out, and a run that continues
/// evaluates it. Each row is on the disk before the next is evaluated. Throws InputError if anything else is damaged,
/// which cannot be restored, and text::OutputError (preparing) if the archive cannot be written.
[[nodiscard]] Repair repair_designs(const std::filesystem::path& path, const EvaluateAgain& again,
                                    const KeepsOn& keeps_on);

/// Writes the designs of one run to an archive, in a thread of its own, a tenth of a second's designs at a time. No
/// evaluation waits for the disk; what add() has taken is on the disk at most 0.2 s later, even if the program ends.
///
/// If the disk refuses (it is full, another process has locked the archive), designs wait in memory, about a kilobyte
/// each, and are tried again every second, at flush() and at the end.
class Writer {
 public:
  /// Gets one line when the disk refuses, with the reason, and one when all waiting designs are written; called on the
  /// writer's thread. May be empty.
  using OnRefusal = std::function<void(const std::string&)>;

  /// Opens an archive that exists and begins a run in it. `max_evaluations` is its budget, if it has one. A lock of
  /// another process is waited for as long as `patience`, after a failure a tenth of that. Throws InputError if the
  /// file is no archive, and text::OutputError (preparing) if it cannot be written.
  Writer(const std::filesystem::path& path, std::optional<std::size_t> max_evaluations, OnRefusal on_refusal,
         std::chrono::milliseconds patience = std::chrono::seconds(10));
  /// Writes the remaining designs if the disk lets it. A run that was not ended stays open.
  ~Writer();
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  /// Takes a design to be written; the writer sets its id and run. Callable from any thread. Returns at once, unless
  /// some thousand designs wait for the disk.
  void add(Row row);

  /// Returns when all designs taken are on the disk or have been refused once more. Then failure() is complete.
  void flush();

  /// Writes the order of the search. The second of each pair is the number of the design that has the first as its id;
  /// all other designs lose their numbers. Call it after flush() and from one thread; it does nothing after a
  /// failure().
  void number(const std::vector<std::pair<std::int64_t, std::size_t>>& numbers);

  /// Ends the run with its stop reason and counts; the writer sets the id and the times. Call it as number().
  void end(const Run& run);

  /// Why designs are not on the disk, with their number; absent if all were written.
  [[nodiscard]] std::optional<std::string> failure() const;

 private:
  class Thread;
  std::unique_ptr<Thread> thread_;
};

}  // namespace coilwright::archive
