#include "coilwright/archive/reader.hpp"

#include <fmt/format.h>
#include <sqlite3.h>

#include <algorithm>
#include <bit>
#include <functional>
#include <limits>
#include <mutex>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "archive/bind.hpp"
#include "archive/database.hpp"
#include "archive/read_contents.hpp"
#include "archive/schema.hpp"

namespace coilwright::archive {
namespace {

std::size_t hash_of(std::span<const Value> values) {
  std::uint64_t hash = 0x9E3779B97F4A7C15ULL;
  for (const Value& value : values) {
    // + 0.0: one zero, not two; equal numbers must have equal hashes.
    const auto* number = std::get_if<double>(&value);
    hash ^= number != nullptr ? std::bit_cast<std::uint64_t>(*number + 0.0)
                              : std::hash<std::string>{}(std::get<std::string>(value));
    hash *= 0xD6E8FEB86659FD93ULL;
    hash ^= hash >> 32;
  }
  return static_cast<std::size_t>(hash);
}

bool is_column(const std::vector<Column>& columns, std::string_view name) {
  return std::ranges::any_of(columns, [&](const Column& each) { return each.column == name; }) ||
         std::ranges::find(fixed_columns, name) != fixed_columns.end();
}

// The condition ends its line, so that a comment in it takes nothing else along.
std::string sql_of(const Query& query) {
  std::string conditions;
  if (!query.where.empty()) conditions = fmt::format(" WHERE ({}\n)", query.where);
  std::string order = " ORDER BY id";
  if (!query.order_by.empty()) {
    const std::string column = sql_name(query.order_by);
    conditions += fmt::format("{} {} IS NOT NULL", conditions.empty() ? " WHERE" : " AND", column);
    order = fmt::format(" ORDER BY {}{}, id", column, query.descending ? " DESC" : "");
  }
  const std::string most = query.most ? std::to_string(*query.most) : "-1";
  return fmt::format("{}{} LIMIT {} OFFSET {}", conditions, order, most, query.skip);
}

// A condition may hold a query without an end. SQLite takes some 1e8 steps a second.
constexpr std::size_t steps = 100'000'000, steps_of_a_design = 10'000, steps_between_looks = 100'000;

int spend(void* looks) {
  auto& left = *static_cast<std::size_t*>(looks);
  return left-- == 0 ? 1 : 0;
}

// Runs a query with a condition. What SQLite says of the condition is its author's mistake; all else is about the file.
template <class Task>
void of_condition(const SQLite::Database& database, std::size_t designs, const std::string& sql, const Task& task) {
  std::size_t looks = (steps + designs * steps_of_a_design) / steps_between_looks;
  const auto end = [](sqlite3* handle) { sqlite3_progress_handler(handle, 0, nullptr, nullptr); };
  const std::unique_ptr<sqlite3, decltype(end)> bounded(database.getHandle(), end);
  sqlite3_progress_handler(bounded.get(), steps_between_looks, &spend, &looks);
  try {
    SQLite::Statement rows(database, sql);
    while (rows.executeStep()) task(rows);
  } catch (const SQLite::Exception& error) {
    if (error.getErrorCode() == SQLITE_INTERRUPT) throw std::invalid_argument("takes too long, or has no end");
    if (error.getErrorCode() == SQLITE_ERROR || error.getErrorCode() == SQLITE_TOOBIG)
      throw std::invalid_argument(error.what());
    throw;
  }
}

}  // namespace

struct Reader::Connection {
  explicit Connection(const std::filesystem::path& file)
      : path(file),
        database(open_to_read(file)),
        has_checksums(whole_archive_has_checksums()),
        contents(reading(file, [this] { return read_contents(database); })),
        counts(counts_of(contents.columns)),
        selection(selection_of(contents.columns)),
        by_id(reading(file, [this] { return SQLite::Statement(database, selection + " WHERE id = ?"); })) {}

  bool whole_archive_has_checksums() {
    require_whole(path, database);
    return version_of(database) >= first_version_with_checksums;
  }

  std::optional<Row> row(std::int64_t id) {
    by_id.reset();
    Binder(by_id).integer(id);
    std::optional<Row> found;
    if (by_id.executeStep()) found = row_of(by_id, counts);
    by_id.reset();  // a statement under way would hold back the log
    return found;
  }

  std::size_t size() {
    return reading(path, [this] {
      SQLite::Statement count(database, "SELECT count(*) FROM designs");
      return count.executeStep() ? static_cast<std::size_t>(count.getColumn(0).getInt64()) : std::size_t{0};
    });
  }

  template <class Task>
  void query(const std::string& sql, const Task& task) {
    reading(path, [&] { of_condition(database, size(), sql, task); });
  }

  // Sixteen bytes a design, and no index that each insertion would have to keep up.
  void build_index() {
    std::string names;
    for (const Column& column : contents.columns)
      if (column.role == Role::variable) names += ", " + sql_name(column.column);
    SQLite::Statement rows(database, fmt::format("SELECT id{} FROM designs", names));
    std::vector<Value> values;
    index.emplace();
    while (rows.executeStep()) {
      values.clear();
      for (int i = 1; i <= static_cast<int>(counts.variables); ++i) {
        const SQLite::Column cell = rows.getColumn(i);
        values.emplace_back(cell.isText() ? Value(cell.getString()) : Value(cell.getDouble()));
      }
      index->emplace_back(hash_of(values), rows.getColumn(0).getInt64());
    }
    std::ranges::sort(*index);
  }

  std::filesystem::path path;
  std::mutex guard;
  SQLite::Database database;
  bool has_checksums;
  Contents contents;
  ColumnCounts counts;
  std::string selection;
  SQLite::Statement by_id;
  std::optional<std::vector<std::pair<std::size_t, std::int64_t>>> index;  // hash of the variables, id
};

Reader::Reader(const std::filesystem::path& path) : connection_(std::make_unique<Connection>(path)) {}
Reader::~Reader() = default;
Reader::Reader(Reader&&) noexcept = default;
Reader& Reader::operator=(Reader&&) noexcept = default;

const std::filesystem::path& Reader::path() const noexcept {
  return connection_->path;
}

const Contents& Reader::contents() const noexcept {
  return connection_->contents;
}

bool Reader::has_checksums() const noexcept {
  return connection_->has_checksums;
}

std::vector<Run> Reader::runs() const {
  const std::scoped_lock lock(connection_->guard);
  return reading(connection_->path, [this] {
    std::vector<Run> runs;
    SQLite::Statement rows(connection_->database,
                           "SELECT run, started_utc, ended_utc, stop_reason, max_evaluations, evaluated, answered, "
                           "reused FROM runs ORDER BY run");
    const auto count = [&](int i) { return static_cast<std::size_t>(rows.getColumn(i).getInt64()); };
    while (rows.executeStep()) {
      runs.push_back({.id = rows.getColumn(0).getInt64(),
                      .started = rows.getColumn(1).getString(),
                      .ended = rows.getColumn(2).getString(),
                      .stop_reason = rows.getColumn(3).getString(),
                      .max_evaluations = rows.isColumnNull(4) ? std::nullopt : std::optional(count(4)),
                      .evaluated = count(5),
                      .answered = count(6),
                      .reused = count(7)});
    }
    return runs;
  });
}

std::size_t Reader::size() const {
  const std::scoped_lock lock(connection_->guard);
  return connection_->size();
}

std::size_t Reader::count(const std::string& where) const {
  const std::scoped_lock lock(connection_->guard);
  std::size_t count = 0;
  connection_->query(fmt::format("SELECT count(*) FROM designs WHERE ({}\n)", where), [&](SQLite::Statement& found) {
    count = static_cast<std::size_t>(found.getColumn(0).getInt64());
  });
  return count;
}

std::vector<Row> Reader::sample(std::size_t count, const std::string& where) const {
  const std::size_t all = this->count(where), taken = std::min(count, all);
  std::vector<Row> rows;
  for (std::size_t k = 0; k < taken; ++k) {
    const std::size_t before = taken > 1 ? k * (all - 1) / (taken - 1) : 0;
    each({.where = where, .skip = before, .most = 1}, [&](const Row& row) { rows.push_back(row); });
  }
  return rows;
}

std::optional<Row> Reader::row(std::int64_t id) const {
  const std::scoped_lock lock(connection_->guard);
  return reading(connection_->path, [&] { return connection_->row(id); });
}

std::optional<Row> Reader::find(std::span<const Value> variables) const {
  const std::scoped_lock lock(connection_->guard);
  return reading(connection_->path, [&]() -> std::optional<Row> {
    if (!connection_->index) connection_->build_index();
    const std::size_t hash = hash_of(variables);
    const std::vector<std::pair<std::size_t, std::int64_t>>& index = *connection_->index;
    const std::pair first{hash, std::numeric_limits<std::int64_t>::min()};
    for (auto entry = std::ranges::lower_bound(index, first); entry != index.end() && entry->first == hash; ++entry) {
      std::optional<Row> row = connection_->row(entry->second);
      if (row && std::ranges::equal(row->variables, variables)) return row;
    }
    return std::nullopt;
  });
}

void Reader::each(const Query& query, const std::function<void(const Row&)>& take) const {
  const std::scoped_lock lock(connection_->guard);
  if (!query.order_by.empty() && !is_column(connection_->contents.columns, query.order_by))
    throw std::invalid_argument("no such column: " + query.order_by);
  connection_->query(connection_->selection + sql_of(query),
                     [&](SQLite::Statement& rows) { take(row_of(rows, connection_->counts)); });
}

}  // namespace coilwright::archive
