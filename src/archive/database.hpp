#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <chrono>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "archive/checksum.hpp"
#include "coilwright/text/input_error.hpp"
#include "coilwright/text/output/output_file.hpp"

namespace coilwright::archive {

/// How long a lock of another process is waited for, which holds the file for milliseconds at a time.
inline constexpr std::chrono::milliseconds usual_patience{10'000};

/// Opens an archive that is there, to be read. Throws InputError for a file that is none, of another program or of a
/// later version, and where it cannot be read. Its checksums are not looked at: require_whole().
[[nodiscard]] SQLite::Database open_to_read(const std::filesystem::path& path);

/// The same to be written to, with a write-ahead log whose commits are on the disk when they return: what is recorded
/// outlives a failing power supply. Throws OutputError (preparing) where it cannot be written.
[[nodiscard]] SQLite::Database open_to_write(const std::filesystem::path& path,
                                             std::chrono::milliseconds patience = usual_patience);

/// What SQLite keeps beside an archive and deletes with its last change: logs of a run that is under way or was killed.
/// Throws InputError where another file stands in the place of one, or no archive beside it.
[[nodiscard]] std::vector<std::filesystem::path> logs_of(const std::filesystem::path& archive);

/// The version of its tables.
[[nodiscard]] int version_of(const SQLite::Database& database);

/// Throws SQLite::Exception where the file system refuses locks: SQLite takes that for a lock that another holds, and
/// asks again for 10 s.
void require_locks(const SQLite::Database& database);

/// Throws InputError where the tree of the file is torn, or a row of these tables is not what was written.
void require_whole(const std::filesystem::path& path, SQLite::Database& database, std::span<const SealedTable> tables);

/// The same of all tables that have checksums: of none where the archive is of before there were any.
void require_whole(const std::filesystem::path& path, SQLite::Database& database);

/// Gives an archive of version 2 the tables of this one, with the rows that it has counted. Throws SQLite::Exception.
void bring_up_to_date(SQLite::Database& database, const std::vector<Column>& columns);

/// Throws std::bad_alloc where SQLite ran out of memory: that says nothing of an archive, and nothing goes on after it.
void require_memory(const SQLite::Exception& error);

/// What SQLite says of a file, and what it does not: that a path is too long for it.
[[nodiscard]] std::string words_of(const std::filesystem::path& path, const SQLite::Exception& error);

/// What SQLite says of an archive: a torn one, or what keeps it from being read just now, with the cure.
[[nodiscard]] text::InputError refusal_of(const std::filesystem::path& path, const SQLite::Exception& error);

/// What SQLite refuses, as an InputError about the archive.
template <class Task>
auto reading(const std::filesystem::path& path, Task&& task) {
  try {
    return std::forward<Task>(task)();
  } catch (const SQLite::Exception& error) {
    require_memory(error);
    throw refusal_of(path, error);
  }
}

/// What SQLite refuses, as an OutputError about the archive.
template <class Task>
auto writing(const std::filesystem::path& path, text::OutputError::Stage stage, Task&& task) {
  try {
    return std::forward<Task>(task)();
  } catch (const SQLite::Exception& error) {
    require_memory(error);
    throw text::OutputError(path, words_of(path, error), stage);
  }
}

}  // namespace coilwright::archive
