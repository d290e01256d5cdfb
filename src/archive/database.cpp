#include "archive/database.hpp"

#include <fmt/format.h>
#include <sqlite3.h>

#include <system_error>

#include "archive/schema.hpp"

namespace coilwright::archive {
namespace {

namespace fs = std::filesystem;

// Another process holds the file for milliseconds at a time.
constexpr int busy_timeout = 10'000;  // ms

// It is there while a change is made that the log does not take: of the way of logging itself, at a run's begin and
// end.
fs::path journal_of(const fs::path& archive) {
  return archive.string() + "-journal";
}

text::InputError error_about(const fs::path& path, const std::string& rule) {
  return text::InputError({.file = path.string(), .place = {}, .rule = rule, .value = {}});
}

// Before anything is asked of a file that may be anything.
void require_archive(const fs::path& path, SQLite::Database& database) {
  std::int32_t application = 0;
  int version = 0;
  try {
    application = database.execAndGet("PRAGMA application_id").getInt();
    version = database.execAndGet("PRAGMA user_version").getInt();
  } catch (const SQLite::Exception& error) {
    // No file of another kind has a journal that SQLite takes for its own.
    if (error.getErrorCode() == SQLITE_READONLY)
      throw error_about(path,
                        fmt::format("was left half-changed by a run that was killed, and is put right only where it "
                                    "may be written: copy it there with {}",
                                    journal_of(path).filename().string()));
    throw error_about(path, std::string("is no archive of a study: ") + error.what());
  }
  if (application != application_id) throw error_about(path, "is no archive of a study: another program wrote it");
  if (version > schema_version)
    throw error_about(path, fmt::format("was written by a later coilwright: it is an archive of version {}, and this "
                                        "program reads up to version {}",
                                        version, schema_version));
}

void require_file(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) throw error_about(path, "cannot be read: there is no such file");
  if (!fs::is_regular_file(status)) throw error_about(path, "cannot be read: it is no regular file");
}

SQLite::Database open(const fs::path& path, int flags) {
  require_file(path);
  // Whoever has a connection lets one thread use it at a time; SQLite need not lock it once more for each value.
  SQLite::Database database =
      reading(path, [&] { return SQLite::Database(path.string(), flags | SQLite::OPEN_NOMUTEX, busy_timeout); });
  require_archive(path, database);
  return database;
}

}  // namespace

SQLite::Database open_to_read(const fs::path& path) {
  // A change that was cut short is taken back by the next who opens the file, but not by one who may only read.
  if (fs::exists(journal_of(path))) static_cast<void>(open(path, SQLite::OPEN_READWRITE));
  return open(path, SQLite::OPEN_READONLY);
}

SQLite::Database open_to_write(const fs::path& path) {
  SQLite::Database database = open(path, SQLite::OPEN_READWRITE);
  writing(path, text::OutputError::Stage::preparing, [&] {
    database.exec("PRAGMA journal_mode = WAL");
    database.exec("PRAGMA synchronous = FULL");
  });
  return database;
}

}  // namespace coilwright::archive
