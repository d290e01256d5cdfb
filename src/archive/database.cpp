#include "archive/database.hpp"

#include <fmt/format.h>
#include <sqlite3.h>

#include <array>
#include <chrono>
#include <fstream>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "archive/checksum.hpp"
#include "archive/read_contents.hpp"
#include "archive/schema.hpp"
#include "coilwright/text/one_line.hpp"

namespace coilwright::archive {
namespace {

namespace fs = std::filesystem;

constexpr int longest_value = 100'000'000;  // bytes; of a study's inputs the largest are 16 MB

// It is there while a change is made that the log does not take: of the way of logging itself, at a run's begin and
// end.
fs::path journal_of(const fs::path& archive) {
  return archive.string() + "-journal";
}

text::InputError error_about(const fs::path& path, const std::string& rule) {
  return text::InputError({.file = path.string(), .place = {}, .rule = rule, .value = {}});
}

constexpr std::string_view cure = "the command that made it makes it anew with --force";

text::InputError damaged(const fs::path& path, const Damage& damage) {
  return error_about(
      path,
      fmt::format("is damaged ({}): {}{}", damage.text,
                  damage.can_be_mended ? "coilwright archive check DIR --repair evaluates such designs anew, or " : "",
                  cure));
}

// Before anything is asked of a file that may be anything.
void require_archive(const fs::path& path, SQLite::Database& database) {
  const auto [application, version] = reading(path, [&] {
    require_locks(database);
    return std::pair(database.execAndGet("PRAGMA application_id").getInt(), version_of(database));
  });
  if (application != application_id)
    throw error_about(path, fmt::format("is no archive of a study: another program wrote it, or it is torn; {}", cure));
  if (version > schema_version)
    throw error_about(path, fmt::format("was written by a later coilwright: it is an archive of version {}, and this "
                                        "program reads up to version {}",
                                        version, schema_version));
  if (version < 1) throw error_about(path, fmt::format("is damaged: no archive has version {}", version));
}

// What SQLite advises for files that anybody may have written: no function of ours in what the schema asks for, no
// write to the schema, neither views nor triggers, and no text larger than any input of a study.
void distrust(SQLite::Database& database) {
  for (const auto& [option, on] :
       {std::pair(SQLITE_DBCONFIG_DEFENSIVE, 1), std::pair(SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0),
        std::pair(SQLITE_DBCONFIG_ENABLE_TRIGGER, 0), std::pair(SQLITE_DBCONFIG_ENABLE_VIEW, 0)})
    sqlite3_db_config(database.getHandle(), option, on, nullptr);
  sqlite3_limit(database.getHandle(), SQLITE_LIMIT_LENGTH, longest_value);
}

// A view may hold a query without an end, a trigger whatever SQL there is.
void require_our_tables_only(const fs::path& path, SQLite::Database& database) {
  const auto other = reading(path, [&]() -> std::optional<std::string> {
    SQLite::Statement others(
        database, fmt::format("SELECT type || ' ' || name FROM sqlite_schema WHERE type <> 'table' OR name NOT IN ({}) "
                              "OR sql NOT LIKE 'CREATE TABLE %'",
                              table_names));
    return others.executeStep() ? std::optional(others.getColumn(0).getString()) : std::nullopt;
  });
  if (other)
    throw error_about(path,
                      fmt::format("is no archive of a study: it must have no more than the tables that coilwright "
                                  "makes, and has {}",
                                  text::in_quotes(*other)));
}

void require_file(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status))
    throw error_about(path, "cannot be read: " + (status.type() == fs::file_type::not_found ? "there is no such file"
                                                                                            : error.message()));
  if (!fs::is_regular_file(status)) throw error_about(path, "cannot be read: it is no regular file");
}

// How what SQLite keeps under these names begins; or it is empty or begins with zeros, as a kill may leave it.
struct KindOfLog {
  const char* suffix;
  std::string_view beginning;
};
constexpr std::array kinds_of_log{KindOfLog{"-wal", "\x37\x7f\x06"}, KindOfLog{"-shm", "\x18\xe2\x2d"},
                                  KindOfLog{"-journal", "\xd9\xd5\x05"}};

bool is_log(const fs::path& path, std::string_view beginning) {
  std::error_code error;
  const fs::file_type type = fs::symlink_status(path, error).type();
  if (type != fs::file_type::regular) return type == fs::file_type::not_found;  // its run has just ended
  std::string head(beginning.size(), '\0');
  std::ifstream(path, std::ios::binary).read(head.data(), static_cast<std::streamsize>(head.size()));
  return head == beginning || head == std::string(beginning.size(), '\0');
}

SQLite::Database open(const fs::path& path, int flags, std::chrono::milliseconds patience = usual_patience) {
  require_file(path);
  (void)logs_of(path);  // what else has such a name, SQLite would take back and delete
  // Whoever has a connection lets one thread use it at a time; SQLite need not lock it once more for each value.
  SQLite::Database database = reading(path, [&] {
    return SQLite::Database(path.string(), flags | SQLite::OPEN_NOMUTEX, static_cast<int>(patience.count()));
  });
  distrust(database);
  require_archive(path, database);
  require_our_tables_only(path, database);
  register_checksum(database);
  return database;
}

}  // namespace

void require_memory(const SQLite::Exception& error) {
  // The index of its log is a part of memory that it maps.
  const int code = error.getExtendedErrorCode();
  if (error.getErrorCode() == SQLITE_NOMEM || code == SQLITE_IOERR_NOMEM || code == SQLITE_IOERR_SHMMAP)
    throw std::bad_alloc();
}

std::string words_of(const fs::path& path, const SQLite::Exception& error) {
  constexpr std::size_t longest_path = 512;  // bytes, SQLite's own bound, from the root on
  std::error_code none;
  const std::size_t length = fs::absolute(path, none).string().size();
  if (error.getErrorCode() != SQLITE_CANTOPEN || length < longest_path - std::string_view("-journal").size())
    return error.what();
  return fmt::format("{} (its path has {} bytes, and SQLite takes some {}: take a shorter one)", error.what(), length,
                     longest_path);
}

text::InputError refusal_of(const fs::path& path, const SQLite::Exception& error) {
  const std::string what = words_of(path, error);
  switch (error.getErrorCode()) {
    case SQLITE_BUSY:
    case SQLITE_PROTOCOL:
      return error_about(path, "is locked: wait for the end of the run that writes to it");
    case SQLITE_READONLY:  // no file of another kind has a journal that SQLite takes for its own
      return error_about(path,
                         fmt::format("was left half-changed by a run that was killed, and is put right only where it "
                                     "may be written: copy it there with {}",
                                     journal_of(path).filename().string()));
    case SQLITE_IOERR:
      if (error.getExtendedErrorCode() == SQLITE_IOERR_SHMSIZE)
        return error_about(path,
                           "is of a run that was killed or is under way, and needs some room on its disk to be read: "
                           "the disk is full");
      [[fallthrough]];
    case SQLITE_CANTOPEN:
    case SQLITE_PERM:
    case SQLITE_FULL:
      return error_about(path, "cannot be read: " + what);
    default:
      return error_about(path, fmt::format("is no archive of a study, or a torn one: {}; {}", what, cure));
  }
}

std::vector<fs::path> logs_of(const fs::path& archive) {
  std::error_code error;
  const bool is_there = fs::exists(fs::symlink_status(archive, error));
  std::vector<fs::path> out;
  for (const KindOfLog& kind : kinds_of_log) {
    fs::path log = archive.string() + kind.suffix;
    if (!fs::exists(fs::symlink_status(log, error))) continue;
    if (!is_there || !is_log(log, kind.beginning))
      throw error_about(log, fmt::format("stands where a log of {} goes, and is none of an archive here: move it away",
                                         archive.filename().string()));
    out.push_back(std::move(log));
  }
  return out;
}

int version_of(const SQLite::Database& database) {
  SQLite::Statement version(database, "PRAGMA user_version");
  return version.executeStep() ? version.getColumn(0).getInt() : 0;
}

void require_locks(const SQLite::Database& database) {
  sqlite3_file* file = nullptr;
  int is_held = 0;
  sqlite3_file_control(database.getHandle(), "main", SQLITE_FCNTL_FILE_POINTER, &file);
  if (file->pMethods->xCheckReservedLock(file, &is_held) != SQLITE_OK)
    throw SQLite::Exception("its file system refuses locks: take a folder on another disk", SQLITE_IOERR);
}

void require_whole(const fs::path& path, SQLite::Database& database, std::span<const SealedTable> tables) {
  const auto damage = reading(path, [&] { return damage_in(database, tables, version_of(database)); });
  if (damage) throw damaged(path, *damage);
}

void require_whole(const fs::path& path, SQLite::Database& database) {
  const auto tables = reading(path, [&] {
    const int version = version_of(database);
    return version >= first_version_with_checksums ? sealed_tables(read_columns(database), version)
                                                   : std::vector<SealedTable>();
  });
  require_whole(path, database, tables);
}

SQLite::Database open_to_read(const fs::path& path) {
  // A change that was cut short is taken back by the next who opens the file, but not by one who may only read.
  std::error_code none;  // require_file() tells of a folder that cannot be looked into
  if (fs::exists(journal_of(path), none)) static_cast<void>(open(path, SQLite::OPEN_READWRITE));
  return open(path, SQLite::OPEN_READONLY);
}

SQLite::Database open_to_write(const fs::path& path, std::chrono::milliseconds patience) {
  SQLite::Database database = open(path, SQLite::OPEN_READWRITE, patience);
  if (reading(path, [&] { return version_of(database); }) < first_version_with_checksums)
    throw error_about(path, "was written by an earlier coilwright, without checksums: nothing is added to it");
  writing(path, text::OutputError::Stage::preparing, [&] {
    database.exec("PRAGMA journal_mode = WAL");
    database.exec("PRAGMA synchronous = FULL");
  });
  return database;
}

void bring_up_to_date(SQLite::Database& database, const std::vector<Column>& columns) {
  if (version_of(database) >= schema_version) return;
  SQLite::Transaction transaction(database);
  database.exec(later_schema_of(columns));
  count_rows(database, sealed_tables(columns, schema_version));
  transaction.commit();
}

}  // namespace coilwright::archive
