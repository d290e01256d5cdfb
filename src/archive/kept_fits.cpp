#include "coilwright/archive/kept_fits.hpp"

#include <fmt/format.h>

#include <memory>
#include <mutex>
#include <utility>

#include "archive/bind.hpp"
#include "archive/checksum.hpp"
#include "archive/database.hpp"

namespace coilwright::archive {
namespace {

constexpr int patience = 1000;  // ms, with a lock of another program

SQLite::Database opened(const std::filesystem::path& path) {
  SQLite::Database database = open_to_write(path);
  writing(path, text::OutputError::Stage::preparing, [&] {
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
    try {
      SQLite::Statement selection(database_, fmt::format("SELECT found FROM fits WHERE asked = ? AND checksum IS {}",
                                                         checksum_sql(std::vector<std::string>{"asked", "found"})));
      Binder(selection).text(asked);
      if (selection.executeStep()) return selection.getColumn(0).getString();
    } catch (const SQLite::Exception&) {
      // A torn page: the fit is made again.
    }
    return std::nullopt;
  }

  void keep(const std::string& asked, const std::string& found) {
    const std::scoped_lock lock(guard_);
    database_.setBusyTimeout(refused_ ? patience / 10 : patience);
    try {
      SQLite::Statement insertion(database_, fmt::format("INSERT OR REPLACE INTO fits VALUES (?1, ?2, {})",
                                                         checksum_sql(std::vector<std::string>{"?1", "?2"})));
      Binder(insertion).text(asked).bytes(found);
      insertion.exec();
      refused_ = false;
    } catch (const SQLite::Exception& error) {
      const text::OutputError refusal(path_, error.what(), text::OutputError::Stage::writing);
      if (!std::exchange(refused_, true))
        on_refusal_(fmt::format("{}; the run goes on, and what it fits meanwhile is not recorded", refusal.what()));
    }
  }

 private:
  std::filesystem::path path_;
  std::function<void(const std::string&)> on_refusal_;
  std::mutex guard_;
  SQLite::Database database_;
  bool refused_{false};
};

}  // namespace

KeptFits open_fits(const std::filesystem::path& path, std::function<void(const std::string&)> on_refusal) {
  const auto table = std::make_shared<TableOfFits>(path, std::move(on_refusal));
  return {.recall = [table](const std::string& asked) { return table->recall(asked); },
          .keep = [table](const std::string& asked, const std::string& found) { table->keep(asked, found); }};
}

}  // namespace coilwright::archive
