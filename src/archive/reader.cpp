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

std::size_t hash_of(std::span<const Value> values, std::string_view choice) {
  std::uint64_t hash = 0x9E3779B97F4A7C15ULL ^ (choice.empty() ? 0 : std::hash<std::string_view>{}(choice));
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

// A condition may hold a query without an end. SQLite takes some 2e7 steps a second; a condition takes tens a design,
// and one that looks at every other design for each as many as there are.
constexpr std::size_t steps = 10'000'000, steps_of_a_design = 5'000, steps_between_looks = 100'000;

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

// A table of designs, in which each is found.
class Shelf {
 public:
  Shelf(SQLite::Database& database, Designs table, const std::vector<Column>& columns)
      : database_(&database),
        counts_(counts_of(table, columns)),
        selection_(selection_of(table, columns)),
        by_id_(database, selection_ + " WHERE id = ?") {}

  [[nodiscard]] const std::string& selection() const noexcept { return selection_; }
  [[nodiscard]] Row row_of(const SQLite::Statement& selected) const { return archive::row_of(selected, counts_); }

  std::optional<Row> row(std::int64_t id) {
    by_id_.reset();
    Binder(by_id_).integer(id);
    std::optional<Row> found;
    if (by_id_.executeStep()) found = row_of(by_id_);
    by_id_.reset();  // a statement under way would hold back the log
    return found;
  }

  std::optional<Row> find(std::span<const Value> values, std::string_view choice) {
    if (!index_) build_index();
    const std::size_t hash = hash_of(values, choice);
    const std::pair first{hash, std::numeric_limits<std::int64_t>::min()};
    for (auto entry = std::ranges::lower_bound(*index_, first); entry != index_->end() && entry->first == hash;
         ++entry) {
      std::optional<Row> found = row(entry->second);
      if (found && found->choice == choice && std::ranges::equal(found->variables, values)) return found;
    }
    return std::nullopt;
  }

 private:
  // Sixteen bytes a design, and no index that each insertion would have to keep up.
  void build_index() {
    SQLite::Statement rows(*database_, selection_);
    index_.emplace();
    while (rows.executeStep()) {
      const Row row = row_of(rows);
      index_->emplace_back(hash_of(row.variables, row.choice), row.id);
    }
    std::ranges::sort(*index_);
  }

  SQLite::Database* database_;
  ColumnCounts counts_;
  std::string selection_;
  SQLite::Statement by_id_;
  std::optional<std::vector<std::pair<std::size_t, std::int64_t>>> index_;  // hash of the variables, id
};

}  // namespace

struct Reader::Connection {
  explicit Connection(const std::filesystem::path& file)
      : path(file),
        database(open_to_read(file)),
        has_checksums(whole_archive_has_checksums()),
        contents(reading(file, [this] { return read_contents(database); })) {
    reading(file, [this] {
      designs.emplace(database, Designs::of_the_study, contents.columns);
      if (version_of(database) >= first_version_with_counts)
        other_choices.emplace(database, Designs::under_other_choices, contents.columns);
    });
  }

  bool whole_archive_has_checksums() {
    require_whole(path, database);
    return version_of(database) >= first_version_with_checksums;
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

  std::filesystem::path path;
  std::mutex guard;
  SQLite::Database database;
  bool has_checksums;
  Contents contents;
  std::optional<Shelf> designs, other_choices;
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
  return reading(connection_->path, [&] { return connection_->designs->row(id); });
}

std::optional<Row> Reader::find(std::span<const Value> variables, std::string_view choice) const {
  const std::scoped_lock lock(connection_->guard);
  std::optional<Shelf>& shelf = choice.empty() ? connection_->designs : connection_->other_choices;
  return reading(connection_->path, [&] { return shelf ? shelf->find(variables, choice) : std::nullopt; });
}

void Reader::each(const Query& query, const std::function<void(const Row&)>& take) const {
  const std::scoped_lock lock(connection_->guard);
  if (!query.order_by.empty() && !is_column(connection_->contents.columns, query.order_by))
    throw std::invalid_argument("no such column: " + query.order_by);
  connection_->query(connection_->designs->selection() + sql_of(query),
                     [&](SQLite::Statement& rows) { take(connection_->designs->row_of(rows)); });
}

}  // namespace coilwright::archive
