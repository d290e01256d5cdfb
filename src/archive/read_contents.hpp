#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <vector>

#include "coilwright/archive/contents.hpp"

namespace coilwright::archive {

/// The columns that the study of an archive brings. Throws SQLite::Exception.
[[nodiscard]] std::vector<Column> read_columns(SQLite::Database& database);

/// What an archive is of. Throws SQLite::Exception.
[[nodiscard]] Contents read_contents(SQLite::Database& database);

}  // namespace coilwright::archive
