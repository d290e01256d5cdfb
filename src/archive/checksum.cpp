#include "archive/checksum.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sqlite3.h>

#include <algorithm>
#include <array>
#include <boost/crc.hpp>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "archive/schema.hpp"

namespace coilwright::archive {
namespace {

// CRC-64/XZ: reflected, from and to all ones.
using Crc = boost::crc_optimal<64, 0x42F0E1EBA9EA3693ULL, ~0ULL, ~0ULL, true, true>;

constexpr const char* function_name = "coilwright_checksum";
constexpr std::size_t most_arguments = 100;  // SQLite's own bound is 127

template <class Number>
void add_number(Crc& crc, Number value) {
  static_assert(sizeof value == 8);
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  std::array<unsigned char, 8> bytes{};  // whatever the order of the machine
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<unsigned char>(bits >> (8 * i));
  crc.process_bytes(bytes.data(), bytes.size());
}

// False where SQLite has no memory for the bytes.
bool add_value(Crc& crc, sqlite3_value* value) {
  const int type = sqlite3_value_type(value);
  crc.process_byte(static_cast<unsigned char>(type));
  switch (type) {
    case SQLITE_INTEGER:
      add_number(crc, static_cast<std::int64_t>(sqlite3_value_int64(value)));
      return true;
    case SQLITE_FLOAT:
      add_number(crc, sqlite3_value_double(value));
      return true;
    case SQLITE_TEXT:
    case SQLITE_BLOB: {
      const void* bytes = type == SQLITE_TEXT ? sqlite3_value_text(value) : sqlite3_value_blob(value);
      const std::int64_t size = sqlite3_value_bytes(value);
      if (size > 0 && bytes == nullptr) return false;
      add_number(crc, size);
      if (size > 0) crc.process_bytes(bytes, static_cast<std::size_t>(size));
      return true;
    }
    default:
      return true;
  }
}

void checksum(sqlite3_context* context, int count, sqlite3_value** values) {
  Crc crc;
  for (int i = 0; i < count; ++i)
    if (!add_value(crc, values[i])) return sqlite3_result_error_nomem(context);
  sqlite3_result_int64(context, static_cast<std::int64_t>(crc.checksum()));
}

constexpr std::string_view recorded = "recorded";  // how many rows each table has
const std::vector<std::string> columns_of_counts{"position", "name", "rows"};

// In one statement, so that it is of one state of an archive that grows.
std::optional<std::string> fault_of(SQLite::Database& database, const SealedTable& table, int version) {
  const bool is_counted = version >= first_version_with_counts && table.name != recorded;
  SQLite::Statement rows(
      database,
      fmt::format("SELECT count(*) FILTER (WHERE broken), min(number) FILTER (WHERE broken), count(*), {} FROM "
                  "(SELECT {} AS number, checksum IS NOT {} AS broken FROM {})",
                  is_counted ? fmt::format("(SELECT rows FROM recorded WHERE name = '{}')", table.name) : "NULL",
                  table.columns.front(), checksum_sql(table.columns), table.name));
  rows.executeStep();
  const std::int64_t broken = rows.getColumn(0).getInt64(), all = rows.getColumn(2).getInt64();
  if (broken > 0)
    return fmt::format("row {} of {} is not what was written{}", rows.getColumn(1).getInt64(), table.name,
                       broken > 1 ? fmt::format(", nor are {} more", broken - 1) : "");
  if (is_counted && rows.isColumnNull(3)) return fmt::format("it does not say how many rows {} has", table.name);
  if (is_counted && rows.getColumn(3).getInt64() != all)
    return fmt::format("{} has {} rows, and {} were written", table.name, all, rows.getColumn(3).getInt64());
  return std::nullopt;
}

}  // namespace

void register_checksum(SQLite::Database& database) {
  database.createFunction(function_name, -1, true, nullptr, &checksum);
}

std::string checksum_sql(std::span<const std::string> expressions) {
  std::string nested;
  while (!expressions.empty()) {
    const std::size_t count = std::min(expressions.size(), most_arguments - 1);
    nested = fmt::format("{}({}{}{})", function_name, nested, nested.empty() ? "" : ", ",
                         fmt::join(expressions.first(count), ", "));
    expressions = expressions.subspan(count);
  }
  return nested;
}

std::vector<SealedTable> sealed_tables(const std::vector<Column>& columns, int version) {
  std::vector<SealedTable> tables{
      {.name = "study",
       .columns = {"rowid", "command", "name", "question_sha256", "algorithm", "seed", "version", "commit_hash",
                   "build_sha256", "actuator_sha256", "operation_sha256", "systems_sha256"}},
      {.name = "inputs", .columns = {"position", "file", "sha256", "content"}},
      {.name = "changes", .columns = {"position", "change"}},
      {.name = "columns", .columns = {"position", "role", "name", "meaning", "column_name"}},
      {.name = "runs",
       .columns = {"run", "started_utc", "ended_utc", "stop_reason", "max_evaluations", "evaluated", "answered",
                   "reused"}}};
  if (version >= first_version_with_counts)
    tables.push_back({.name = std::string(recorded), .columns = columns_of_counts});
  for (const Designs table : tables_of_designs)
    if (table == Designs::of_the_study || version >= first_version_with_counts)
      tables.push_back({.name = name_of(table), .columns = design_columns(table, columns)});
  return tables;
}

std::string sealing_of(const SealedTable& table) {
  return fmt::format("UPDATE {} SET checksum = {}", table.name, checksum_sql(table.columns));
}

void count_rows(SQLite::Database& database, std::span<const SealedTable> tables) {
  int position = 0;
  for (const SealedTable& table : tables)
    database.exec(fmt::format("INSERT OR REPLACE INTO recorded SELECT {}, '{}', count(*), NULL FROM {}", ++position,
                              table.name, table.name));
  database.exec(sealing_of(*std::ranges::find(tables, recorded, &SealedTable::name)));
}

void count_more(SQLite::Database& database, std::string_view table, std::int64_t rows) {
  const std::vector<std::string> row{"position", "name", fmt::format("rows + {}", rows)};
  database.exec(fmt::format("UPDATE recorded SET rows = {}, checksum = {} WHERE name = '{}'", row.back(),
                            checksum_sql(row), table));
}

std::int64_t missing_designs(SQLite::Database& database) {
  const std::string whole = checksum_sql(columns_of_counts);
  std::int64_t missing = 0;
  for (const Designs table : tables_of_designs)
    missing += database
                   .execAndGet(fmt::format("SELECT ifnull(sum(rows - (SELECT count(*) FROM {0})), 0) FROM recorded "
                                           "WHERE name = '{0}' AND checksum IS {1}",
                                           name_of(table), whole))
                   .getInt64();
  return missing;
}

bool can_be_mended(std::string_view table) {
  return table == recorded ||
         std::ranges::any_of(tables_of_designs, [&](Designs each) { return name_of(each) == table; });
}

std::optional<Damage> damage_in(SQLite::Database& database, std::span<const SealedTable> tables, int version) {
  const std::string tree = database.execAndGet("PRAGMA quick_check(1)").getString();
  if (tree != "ok") return Damage{.text = tree};
  for (const SealedTable& table : tables)
    if (std::optional<std::string> text = fault_of(database, table, version))
      return Damage{.text = *std::move(text), .can_be_mended = can_be_mended(table.name)};
  return std::nullopt;
}

}  // namespace coilwright::archive
