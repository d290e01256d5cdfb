#include "coilwright/archive/writer.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <exception>
#include <map>
#include <mutex>
#include <span>
#include <system_error>
#include <thread>
#include <utility>

#include "archive/bind.hpp"
#include "archive/checksum.hpp"
#include "archive/database.hpp"
#include "archive/read_contents.hpp"
#include "archive/schema.hpp"
#include "coilwright/text/one_line.hpp"

namespace coilwright::archive {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

// How long designs are gathered: a commit waits for the disk, some milliseconds.
constexpr auto gathering = 100ms;
// So many designs are written at once, and so many may wait for it. Some 600 bytes each.
constexpr std::size_t batch = 2048, most_waiting = 16384;
// So many are tried where more were refused: a disk that has no room for all of them may have it for some.
constexpr std::size_t few = 16;
// How soon a disk that refuses is tried again.
constexpr auto pause = 1s;

constexpr const char* now = "strftime('%Y-%m-%dT%H:%M:%SZ', 'now')";

constexpr const char* all_of_study = "INSERT INTO study VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, NULL)";

void write_contents(SQLite::Database& database, const Contents& contents) {
  SQLite::Transaction transaction(database);
  database.exec(schema_of(contents.columns));
  SQLite::Statement study(database, all_of_study);
  Binder(study)
      .text(contents.command)
      .text(contents.study)
      .text(contents.question)
      .text(contents.algorithm)
      .integer(contents.seed)
      .text(contents.program.version)
      .text(contents.program.commit)
      .text(contents.program.build)
      .text(contents.physics.actuator)
      .text(contents.physics.operation)
      .text(contents.physics.systems);
  study.exec();
  SQLite::Statement input(database, "INSERT INTO inputs (file, sha256, content) VALUES (?, ?, ?)");
  for (const Input& each : contents.inputs) {
    input.reset();
    Binder(input).text(each.file).text(each.sha256).bytes(each.text);
    input.exec();
  }
  SQLite::Statement change(database, "INSERT INTO changes (change) VALUES (?)");
  for (const std::string& each : contents.changes) {
    change.reset();
    Binder(change).text(each);
    change.exec();
  }
  SQLite::Statement column(database, "INSERT INTO columns (role, name, meaning, column_name) VALUES (?, ?, ?, ?)");
  for (const Column& each : contents.columns) {
    column.reset();
    Binder(column).text(name_of(each.role)).text(each.name).text(each.meaning).text(each.column);
    column.exec();
  }
  const std::vector<SealedTable> tables = sealed_tables(contents.columns, schema_version);
  for (const SealedTable& table : tables) database.exec(sealing_of(table));
  count_rows(database, tables);
  transaction.commit();
}

void remove_quietly(const fs::path& path) {
  std::error_code ignored;
  fs::remove(path, ignored);
}

}  // namespace

void create(const fs::path& path, const Contents& contents) {
  constexpr auto preparing = text::OutputError::Stage::preparing;
  const fs::path part = path.parent_path() / fmt::format(".{}.part-{}", path.filename().string(), getpid());
  // What a run that was killed left beside the file belongs to the one that is replaced, and would be played into this.
  const std::vector<fs::path> logs = logs_of(path);
  remove_quietly(part);
  try {
    writing(path, preparing, [&] {
      SQLite::Database database(part.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
      require_locks(database);
      register_checksum(database);
      write_contents(database, contents);
    });
    for (const fs::path& log : logs) remove_quietly(log);
    std::error_code error;
    fs::rename(part, path, error);
    if (error) throw text::OutputError(path, error.message(), preparing);
  } catch (...) {
    remove_quietly(part);
    remove_quietly(part.string() + "-journal");
    throw;
  }
}

namespace {

// The designs of a table that are not what was written.
std::vector<Row> damaged_in(SQLite::Database& database, Designs table, const std::vector<Column>& columns) {
  std::vector<Row> damaged;
  SQLite::Statement found(database, fmt::format("{} WHERE checksum IS NOT {} ORDER BY id", selection_of(table, columns),
                                                checksum_sql(design_columns(table, columns))));
  while (found.executeStep()) damaged.push_back(row_of(found, counts_of(table, columns)));
  return damaged;
}

// Mends or takes out one design, on the disk before the next is evaluated.
void mend(SQLite::Database& database, Designs table, const std::vector<Column>& columns, const Row& row,
          Repair& repair) {
  SQLite::Transaction transaction(database);
  SQLite::Statement mending(database, mending_of(table, columns));
  bind_row(mending, table, row, row.id, row.run);
  if (mending.exec() > 0) {
    ++repair.mended;
  } else {
    database.exec(fmt::format("DELETE FROM {} WHERE id = {}", name_of(table), row.id));
    count_more(database, name_of(table), -1);
    table == Designs::of_the_study ? repair.dropped.push_back(row.id) : void(++repair.dropped_choices);
  }
  transaction.commit();
}

}  // namespace

Repair repair_designs(const fs::path& path, const EvaluateAgain& again, const KeepsOn& keeps_on) {
  SQLite::Database database = open_to_write(path);
  const Contents contents = reading(path, [&] { return read_contents(database); });
  std::vector<SealedTable> tables = sealed_tables(contents.columns, version_of(database));
  std::erase_if(tables, [](const SealedTable& table) { return can_be_mended(table.name); });
  require_whole(path, database, tables);
  Repair repair;
  writing(path, text::OutputError::Stage::preparing, [&] {
    bring_up_to_date(database, contents.columns);
    std::vector<std::pair<Designs, Row>> damaged;
    for (const Designs table : tables_of_designs)
      for (Row& row : damaged_in(database, table, contents.columns)) damaged.emplace_back(table, std::move(row));
    for (auto& [table, row] : damaged) {
      if (!keeps_on(repair.looked_at(), damaged.size())) break;
      if (std::optional<sizing::Evaluation> evaluation = again(contents, row)) row.evaluation = *std::move(evaluation);
      mend(database, table, contents.columns, row, repair);
    }
    repair.left = damaged.size() - repair.looked_at();
    repair.gone = missing_designs(database);
    SQLite::Transaction transaction(database);
    count_rows(database, sealed_tables(contents.columns, schema_version));
    transaction.commit();
  });
  database.tryExec("PRAGMA journal_mode = DELETE");
  return repair;
}

// Everything of the database but the first and the last words is said on one thread.
class Writer::Thread {
 public:
  Thread(fs::path path, std::optional<std::size_t> max_evaluations, OnRefusal on_refusal,
         std::chrono::milliseconds patience)
      : path_(std::move(path)),
        database_(open_to_write(path_)),
        on_refusal_(std::move(on_refusal)),
        patience_(static_cast<int>(patience.count())) {
    database_.setBusyTimeout(patience_);
    columns_ = reading(path_, [&] { return read_columns(database_); });
    writing(path_, text::OutputError::Stage::preparing, [&] {
      bring_up_to_date(database_, columns_);
      SQLite::Transaction transaction(database_);
      SQLite::Statement run(database_,
                            fmt::format("INSERT INTO runs (started_utc, max_evaluations) VALUES ({}, ?)", now));
      Binder(run).integer(max_evaluations);
      run.exec();
      run_ = database_.getLastInsertRowid();
      seal_run();
      count_more(database_, "runs", 1);
      transaction.commit();
      for (const Designs table : tables_of_designs)
        insertions_.emplace(
            table, Insertion{.statement = {database_, insertion_of(table, columns_)}, .last_id = last_id_in(table)});
    });
    thread_ = std::jthread([this](const std::stop_token& stop) {
      try {
        work(stop);
      } catch (...) {  // it is thrown on the thread of the run, which ends by it
        const std::scoped_lock lock(guard_);
        thrown_ = std::current_exception();
        changed_.notify_all();
      }
    });
  }

  ~Thread() {
    thread_.request_stop();
    if (thread_.joinable()) thread_.join();
    insertions_.clear();
    // A finished archive is one file, which is read where nothing can be written. Not while another program reads it.
    database_.tryExec("PRAGMA journal_mode = DELETE");
  }
  Thread(const Thread&) = delete;
  Thread& operator=(const Thread&) = delete;

  void add(Row row) {
    std::unique_lock lock(guard_);
    changed_.wait(lock, [this] { return waiting_.size() < most_waiting || refusal_ || thrown_; });
    if (thrown_) std::rethrow_exception(thrown_);
    waiting_.push_back(std::move(row));
    if (waiting_.size() == 1 || waiting_.size() >= batch) changed_.notify_all();
  }

  void flush() {
    std::unique_lock lock(guard_);
    hurry_ = true;
    changed_.notify_all();
    const std::size_t before = refusals_ + (writing_ > 0 ? 1 : 0);  // what is under way may have begun long ago
    changed_.wait(lock, [&] { return (waiting_.empty() && writing_ == 0) || refusals_ > before || thrown_; });
    if (thrown_) std::rethrow_exception(thrown_);
    hurry_ = false;
  }

  [[nodiscard]] std::optional<std::string> failure() const {
    const std::scoped_lock lock(guard_);
    const std::size_t missing = waiting_.size() + writing_;
    if (!refusal_ || missing == 0) return refusal_;
    return fmt::format("{}; designs that are not recorded: {}", *refusal_, missing);
  }

  void number(const std::vector<std::pair<std::int64_t, std::size_t>>& numbers) {
    attempt([&] {
      SQLite::Transaction transaction(database_);
      database_.exec(numbering_of(columns_, "NULL") + " WHERE number IS NOT NULL");
      SQLite::Statement update(database_, numbering_of(columns_, "?1") + " WHERE id = ?2");
      for (const auto& [id, number] : numbers) {
        update.reset();
        Binder(update).integer(number).integer(id);
        update.exec();
      }
      transaction.commit();
    });
  }

  void end(const Run& run) {
    attempt([&] {
      SQLite::Transaction transaction(database_);
      SQLite::Statement update(database_, fmt::format("UPDATE runs SET ended_utc = {}, stop_reason = ?, evaluated = ?, "
                                                      "answered = ?, reused = ? WHERE run = ?",
                                                      now));
      Binder(update)
          .text(run.stop_reason)
          .integer(run.evaluated)
          .integer(run.answered)
          .integer(run.reused)
          .integer(run_);
      update.exec();
      seal_run();
      transaction.commit();
    });
  }

 private:
  void seal_run() {
    for (const SealedTable& table : sealed_tables(columns_, schema_version))
      if (table.name == "runs") database_.exec(fmt::format("{} WHERE run = {}", sealing_of(table), run_));
  }

  void work(const std::stop_token& stop) {
    for (bool refused = false, last = false; !(refused && last);) {
      std::vector<Row> rows;
      bool all = false;
      {
        std::unique_lock lock(guard_);
        changed_.wait(lock, stop, [this] { return !waiting_.empty(); });
        if (waiting_.empty()) return;  // asked to stop, and all is done
        changed_.wait_for(lock, stop, refused ? pause : gathering,
                          [&] { return hurry_ || (!refused && waiting_.size() >= batch); });
        const auto end =
            waiting_.begin() + static_cast<std::ptrdiff_t>(std::min(refused ? few : batch, waiting_.size()));
        rows.assign(std::make_move_iterator(waiting_.begin()), std::make_move_iterator(end));
        waiting_.erase(waiting_.begin(), end);
        all = waiting_.empty();
        writing_ = rows.size();
        changed_.notify_all();
      }
      last = stop.stop_requested();
      std::optional<std::string> refusal;
      try {
        insert(rows);
        rows.clear();
      } catch (const SQLite::Exception& error) {
        require_memory(error);
        refusal = refusal_of(error);
      }
      refused = refusal.has_value();
      database_.setBusyTimeout(refused ? patience_ / 10 : patience_);
      settle(std::move(rows), refusal, all);
    }
  }

  // Keeps for later what is left, before what came meanwhile, and tells of the first refusal and of its end.
  void settle(std::vector<Row> left, const std::optional<std::string>& refusal, bool all) {
    std::unique_lock lock(guard_);
    waiting_.insert(waiting_.begin(), std::make_move_iterator(left.begin()), std::make_move_iterator(left.end()));
    std::string news;
    if (refusal && !refusal_) news = *refusal + "; the run goes on, and what waits to be recorded is tried again";
    if (!refusal && refusal_ && all)
      news = fmt::format("{}: is written again, with all that waited", text::one_line(path_.string(), 600));
    if (!news.empty()) refusal_ = refusal;
    if (!news.empty() && on_refusal_) {
      lock.unlock();
      on_refusal_(news);
      lock.lock();
    }
    if (refusal) ++refusals_;
    writing_ = 0;
    changed_.notify_all();
  }

  void insert(std::span<const Row> rows) {
    require_locks(database_);
    SQLite::Transaction transaction(database_);
    std::map<Designs, std::int64_t> more;
    for (const Row& row : rows) {
      const Designs table = table_of(row.choice);
      Insertion& insertion = insertions_.at(table);
      insertion.statement.tryReset();  // it has the error of an earlier attempt, which is known
      bind_row(insertion.statement, table, row, insertion.last_id + ++more[table], run_);
      insertion.statement.exec();
    }
    for (const auto& [table, count] : more) count_more(database_, name_of(table), count);
    transaction.commit();
    for (const auto& [table, count] : more) insertions_.at(table).last_id += count;
  }

  [[nodiscard]] std::int64_t last_id_in(Designs table) {
    return database_.execAndGet("SELECT ifnull(max(id), 0) FROM " + name_of(table)).getInt64();
  }

  [[nodiscard]] std::string refusal_of(const SQLite::Exception& error) const {
    return text::OutputError(path_, error.what(), text::OutputError::Stage::writing).what();
  }

  // Does what writes, unless designs are missing.
  template <class Task>
  void attempt(const Task& task) {
    if (failure()) return;
    try {
      require_locks(database_);
      task();
    } catch (const SQLite::Exception& error) {
      require_memory(error);
      const std::scoped_lock lock(guard_);
      refusal_ = refusal_of(error);
    }
  }

  fs::path path_;
  SQLite::Database database_;
  OnRefusal on_refusal_;
  int patience_;  // ms
  std::vector<Column> columns_;
  std::int64_t run_{};
  struct Insertion {
    SQLite::Statement statement;
    std::int64_t last_id{};  // of the designs that are written
  };
  std::map<Designs, Insertion> insertions_;

  mutable std::mutex guard_;
  std::condition_variable_any changed_;
  std::deque<Row> waiting_;
  std::optional<std::string> refusal_;  // what the disk said first, until it takes all again
  std::size_t refusals_{};
  std::exception_ptr thrown_{};  // what ended the thread
  std::size_t writing_{};        // so many are being written
  bool hurry_{false};
  std::jthread thread_;  // last: it uses the others
};

Writer::Writer(const fs::path& path, std::optional<std::size_t> max_evaluations, OnRefusal on_refusal,
               std::chrono::milliseconds patience)
    : thread_(std::make_unique<Thread>(path, max_evaluations, std::move(on_refusal), patience)) {}
Writer::~Writer() = default;

void Writer::add(Row row) {
  thread_->add(std::move(row));
}
void Writer::flush() {
  thread_->flush();
}
void Writer::number(const std::vector<std::pair<std::int64_t, std::size_t>>& numbers) {
  thread_->number(numbers);
}
void Writer::end(const Run& run) {
  thread_->end(run);
}
std::optional<std::string> Writer::failure() const {
  return thread_->failure();
}

}  // namespace coilwright::archive
