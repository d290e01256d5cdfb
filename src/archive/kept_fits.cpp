#include "coilwright/archive/kept_fits.hpp"

#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <mutex>
#include <utility>

#include "archive/bind.hpp"
#include "archive/checksum.hpp"
#include "archive/database.hpp"

namespace coilwright::archive {
namespace {

// With a lock: only readers have one, and where the file system has none SQLite takes the error for a lock that is
// held.
constexpr std::chrono::milliseconds patience{200};
// In a row, before nothing more is recorded: a disk may be full for a moment.
constexpr int most_refusals = 2;

SQLite::Database opened(const std::filesystem::path& path) {
  SQLite::Database database = open_to_write(path, patience);
  writing(path, text::OutputError::Stage::preparing, [&] {
    // Locked once for all, from the next change on: where locks begin to fail SQLite asks again for 10 s each time.
    database.exec("PRAGMA locking_mode = EXCLUSIVE; BEGIN EXCLUSIVE; COMMIT");
    // There are hundreds of fits, and one that a power cut took is made again.
    database.exec("PRAGMA synchronous = NORMAL");
    database.exec(
        "CREATE TABLE IF NOT EXISTS fits (asked TEXT PRIMARY KEY, found BLOB NOT NULL, checksum INTEGER) WITHOUT "
        "ROWID");
  });
  return database;
}

class TableOfFits {
 public:
  TableOfFits(const std::filesystem::path& path, std::function<void(const std::string&)> on_refusal)
      : path_(path), on_refusal_(std::move(on_refusal)), database_(opened(path)) {}

  std::optional<std::string> recall(const std::string& asked) {
    const std::scoped_lock lock(guard_);
    if (refusals_ == most_refusals) return std::nullopt;
    try {
      SQLite::Statement selection(database_, fmt::format("SELECT found FROM fits WHERE asked = ? AND checksum IS {}",
                                                         checksum_sql(std::vector<std::string>{"asked", "found"})));
      Binder(selection).text(asked);
      if (selection.executeStep()) return selection.getColumn(0).getString();
    } catch (const SQLite::Exception& error) {
      require_memory(error);
      // A torn page, or no lock: the fit is made again.
    }
    return std::nullopt;
  }

  void keep(const std::string& asked, const std::string& found) {
    const std::scoped_lock lock(guard_);
    if (refusals_ == most_refusals) return;
    try {
      SQLite::Statement insertion(database_, fmt::format("INSERT OR REPLACE INTO fits VALUES (?1, ?2, {})",
                                                         checksum_sql(std::vector<std::string>{"?1", "?2"})));
      Binder(insertion).text(asked).bytes(found);
      insertion.exec();
      refusals_ = 0;
    } catch (const SQLite::Exception& error) {
      require_memory(error);
      if (++refusals_ == most_refusals)
        on_refusal_(text::OutputError(path_, error.what(), text::OutputError::Stage::writing).what());
    }
  }

 private:
  std::filesystem::path path_;
  std::function<void(const std::string&)> on_refusal_;
  std::mutex guard_;
  SQLite::Database database_;
  int refusals_{0};
};

}  // namespace

KeptFits open_fits(const std::filesystem::path& path, std::function<void(const std::string&)> on_refusal) {
  const auto table = std::make_shared<TableOfFits>(path, std::move(on_refusal));
  return {.recall = [table](const std::string& asked) { return table->recall(asked); },
          .keep = [table](const std::string& asked, const std::string& found) { table->keep(asked, found); }};
}

}  // namespace coilwright::archive
