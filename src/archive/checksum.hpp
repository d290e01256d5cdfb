#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "coilwright/archive/contents.hpp"

namespace coilwright::archive {

/// Makes the SQL function of checksum_sql() known to a connection.
void register_checksum(SQLite::Database& database);

/// The checksum of these SQL expressions, as SQL: CRC-64/XZ (polynomial 0x42F0E1EBA9EA3693 of ECMA-182) over type,
/// length and bytes of each value in turn, nested where SQLite allows no more arguments. Rows of the same length that
/// differ in one run of up to 64 bits never share it; others by chance, one time in 2^64.
[[nodiscard]] std::string checksum_sql(std::span<const std::string> expressions);

/// A table each of whose rows has a checksum in its last column.
struct SealedTable {
  std::string name;
  std::vector<std::string> columns;  ///< that the checksum is of, as SQL, the row's number first
};

/// All tables of an archive of that version with these columns of a study; those of designs are the last.
[[nodiscard]] std::vector<SealedTable> sealed_tables(const std::vector<Column>& columns, int version);

/// "UPDATE runs SET checksum = ..." of a table.
[[nodiscard]] std::string sealing_of(const SealedTable& table);

/// Tells the table `recorded` how many rows each of these tables has.
void count_rows(SQLite::Database& database, std::span<const SealedTable> tables);

/// Tells it that a table has so many rows more.
void count_more(SQLite::Database& database, std::string_view table, std::int64_t rows);

/// How many more designs were written than the tables of designs have, in an archive that counts.
[[nodiscard]] std::int64_t missing_designs(SQLite::Database& database);

/// Whether the rows of a table of that name can be made again: designs and counts.
[[nodiscard]] bool can_be_mended(std::string_view table);

/// What keeps the rows of the tables from being those that were written.
struct Damage {
  std::string text;      ///< the tree as SQLite finds it, the first row whose checksum does not hold, or what is gone
  bool can_be_mended{};  ///< whether it is in what can be evaluated or counted again
};

/// The first damage of these tables, in their order; nothing where all is whole. Throws SQLite::Exception.
[[nodiscard]] std::optional<Damage> damage_in(SQLite::Database& database, std::span<const SealedTable> tables,
                                              int version);

}  // namespace coilwright::archive
