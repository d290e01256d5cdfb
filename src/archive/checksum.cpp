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

void add_value(Crc& crc, sqlite3_value* value) {
  const int type = sqlite3_value_type(value);
  crc.process_byte(static_cast<unsigned char>(type));
  switch (type) {
    case SQLITE_INTEGER:
      return add_number(crc, static_cast<std::int64_t>(sqlite3_value_int64(value)));
    case SQLITE_FLOAT:
      return add_number(crc, sqlite3_value_double(value));
    case SQLITE_TEXT:
    case SQLITE_BLOB: {
      const void* bytes = type == SQLITE_TEXT ? sqlite3_value_text(value) : sqlite3_value_blob(value);
      const std::int64_t size = sqlite3_value_bytes(value);
      add_number(crc, size);
      if (size > 0) crc.process_bytes(bytes, static_cast<std::size_t>(size));
      return;
    }
    default:
      return;
  }
}

void checksum(sqlite3_context* context, int count, sqlite3_value** values) {
  Crc crc;
  for (int i = 0; i < count; ++i) add_value(crc, values[i]);
  sqlite3_result_int64(context, static_cast<std::int64_t>(crc.checksum()));
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

std::vector<SealedTable> sealed_tables(const std::vector<Column>& columns) {
  return {{.name = "study",
           .columns = {"rowid", "command", "name", "question_sha256", "algorithm", "seed", "version", "commit_hash",
                       "build_sha256", "actuator_sha256", "operation_sha256", "systems_sha256"}},
          {.name = "inputs", .columns = {"position", "file", "sha256", "content"}},
          {.name = "changes", .columns = {"position", "change"}},
          {.name = "columns", .columns = {"position", "role", "name", "meaning", "column_name"}},
          {.name = "runs",
           .columns = {"run", "started_utc", "ended_utc", "stop_reason", "max_evaluations", "evaluated", "answered",
                       "reused"}},
          {.name = "designs", .columns = design_columns(columns)}};
}

std::string sealing_of(const SealedTable& table) {
  return fmt::format("UPDATE {} SET checksum = {}", table.name, checksum_sql(table.columns));
}

std::optional<Damage> damage_in(SQLite::Database& database, std::span<const SealedTable> tables) {
  const std::string tree = database.execAndGet("PRAGMA quick_check(1)").getString();
  if (tree != "ok") return Damage{.text = tree};
  for (const SealedTable& table : tables) {
    SQLite::Statement broken(database, fmt::format("SELECT count(*), min({0}) FROM {1} WHERE checksum IS NOT {2}",
                                                   table.columns.front(), table.name, checksum_sql(table.columns)));
    if (!broken.executeStep()) continue;
    const std::int64_t count = broken.getColumn(0).getInt64();
    if (count == 0) continue;
    const std::string more = count > 1 ? fmt::format(", nor are {} more", count - 1) : "";
    return Damage{
        .text = fmt::format("row {} of {} is not what was written{}", broken.getColumn(1).getInt64(), table.name, more),
        .only_in_designs = table.name == "designs"};
  }
  return std::nullopt;
}

}  // namespace coilwright::archive
