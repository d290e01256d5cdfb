// Archives that were written and are read back: every bit, contents, queries, refusals.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

#include <bit>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <memory>
#include <set>
#include <string>
#include <thread>

#include "coilwright/archive/reader.hpp"
#include "coilwright/archive/writer.hpp"
#include "coilwright/text/input_error.hpp"
#include "coilwright/text/output/output_file.hpp"
#include "error_text.hpp"
#include "random_draw.hpp"
#include "temporary_folder.hpp"

namespace coilwright::archive {
namespace {

const std::string cure = "; the command that made it makes it anew with --force";

using coilwright::testing::TemporaryFolder;
using ::testing::HasSubstr;

Contents contents() {
  return {.command = "pareto",
          .study = "a \"study\"",
          .program = {.version = "0.1.0", .commit = std::string(40, 'c'), .build = ""},
          .inputs = {{.file = "study.json", .sha256 = std::string(64, '1'), .text = "{\"x\":\n1}"},
                     {.file = "finger.json", .sha256 = std::string(64, '2'), .text = std::string("a\0b", 3)}},
          .changes = {"front_length_mm=9"},
          .question = std::string(64, '3'),
          .physics = {.actuator = "4", .operation = "5", .systems = ""},
          .algorithm = "automatic",
          .seed = 7,
          .columns = {{.role = Role::variable, .name = "gap_mm", .meaning = {}, .column = "gap_mm"},
                      {.role = Role::variable, .name = "configuration", .meaning = {}, .column = "configuration"},
                      {.role = Role::objective, .name = "mass_g", .meaning = "minimise", .column = "objective_1"},
                      {.role = Role::constraint, .name = "mass_g <= 70", .meaning = {}, .column = "constraint_1"},
                      {.role = Role::quantity, .name = "mass_g", .meaning = "mass", .column = "mass_g"},
                      {.role = Role::quantity, .name = "grip N", .meaning = "a \"grip\"", .column = "grip N"}}};
}

Row design(double gap, double mass, std::optional<double> grip) {
  return {.variables = {gap, std::string("B")},
          .evaluation = {.objectives = {mass}, .constraints = {mass / 70 - 1}, .quantities = {mass, grip}},
          .seconds = 0.5,
          .ended = 1.75e9};
}

class Archive : public ::testing::Test {
 protected:
  void write(const std::vector<Row>& rows) {
    create(path_, contents());
    Writer writer(path_, 60, {});
    for (const Row& row : rows) writer.add(row);
    writer.flush();
    EXPECT_EQ(writer.failure(), std::nullopt);
    writer.end({.stop_reason = "converged", .evaluated = rows.size(), .answered = 0, .reused = 0});
  }

  void execute(const std::string& sql) const {
    sqlite3* database = nullptr;
    ASSERT_EQ(sqlite3_open(path_.c_str(), &database), SQLITE_OK);
    ASSERT_EQ(sqlite3_exec(database, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK);
    sqlite3_close(database);
  }

  std::string refusal() const {
    try {
      const Reader reader(path_);
    } catch (const text::InputError& error) {
      return error.fault().rule;
    }
    return {};
  }

  TemporaryFolder folder_;
  std::filesystem::path path_ = folder_.path() / "archive.sqlite";
};

TEST_F(Archive, GivesBackItsContents) {
  create(path_, contents());
  EXPECT_EQ(Reader(path_).contents(), contents());
  Contents without_a_seed = contents();
  without_a_seed.seed = std::nullopt;
  without_a_seed.changes.clear();
  create(path_, without_a_seed);
  EXPECT_EQ(Reader(path_).contents(), without_a_seed);
}

// Numbers that a column with a type would change (-0.0), or that text or float would.
TEST_F(Archive, KeepsEveryBitOfANumber) {
  std::vector<double> numbers{0.0,
                              -0.0,
                              0.1,
                              1.0 / 3.0,
                              5.0,
                              -3.0,
                              9007199254740993.0,
                              std::nextafter(1.0, 2.0),
                              std::numeric_limits<double>::denorm_min(),
                              std::numeric_limits<double>::max(),
                              -std::numeric_limits<double>::infinity()};
  std::vector<Row> rows;
  for (const double number : numbers) rows.push_back(design(number, number, number));
  write(rows);
  const Reader reader(path_);
  ASSERT_EQ(reader.size(), numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const Row row = reader.row(static_cast<std::int64_t>(i) + 1).value();
    const auto bits = std::bit_cast<std::uint64_t>(numbers[i]);
    EXPECT_EQ(std::bit_cast<std::uint64_t>(std::get<double>(row.variables[0])), bits);
    EXPECT_EQ(std::bit_cast<std::uint64_t>(row.evaluation.objectives.at(0)), bits);
    EXPECT_EQ(std::bit_cast<std::uint64_t>(row.evaluation.quantities.at(1).value()), bits);
  }
}

TEST_F(Archive, TellsApartWhatHasNoValueAndWhatHasNoQuantities) {
  Row failed{.variables = {1.0, std::string("A")},
             .evaluation = {.failure = "too tight, \"very\"\n", .infeasibility = 1.25}};
  Row absent = failed;
  absent.variables = {2.0, std::string("A")};
  absent.evaluation.quantities = {std::nullopt, std::nullopt};
  Row heavy = design(3.0, 80.0, std::nullopt);
  heavy.evaluation.infeasibility = std::numeric_limits<double>::infinity();
  write({failed, absent, heavy});
  const Reader reader(path_);
  EXPECT_EQ(reader.row(1)->evaluation, failed.evaluation);
  EXPECT_EQ(reader.row(2)->evaluation, absent.evaluation);
  EXPECT_EQ(reader.row(3)->evaluation, heavy.evaluation);
  EXPECT_EQ(reader.row(4), std::nullopt);
  EXPECT_EQ(reader.count("status = 'failed'"), 2U);
  EXPECT_EQ(reader.count("status = 'infeasible'"), 1U);
}

TEST_F(Archive, FindsADesignByItsVariables) {
  write({design(0.7, 60, 1.5), design(0.9, 61, 1.25), design(-0.0, 62, 1.0)});
  const Reader reader(path_);
  EXPECT_EQ(reader.find(std::vector<Value>{0.9, std::string("B")})->id, 2);
  EXPECT_EQ(reader.find(std::vector<Value>{0.0, std::string("B")})->id, 3);
  EXPECT_EQ(reader.find(std::vector<Value>{0.9, std::string("A")}), std::nullopt);
  EXPECT_EQ(reader.find(std::vector<Value>{std::nextafter(0.9, 1.0), std::string("B")}), std::nullopt);
}

TEST_F(Archive, SelectsAndOrders) {
  write({design(0.7, 60, 1.5), design(0.9, 75, std::nullopt), design(1.1, 62, 3.5)});
  const Reader reader(path_);
  const auto gaps = [&](const Query& query) {
    std::vector<double> values;
    reader.each(query, [&](const Row& row) { values.push_back(std::get<double>(row.variables[0])); });
    return values;
  };
  EXPECT_THAT(gaps({}), ::testing::ElementsAre(0.7, 0.9, 1.1));
  EXPECT_THAT(gaps({.where = "mass_g > 61 -- a comment"}), ::testing::ElementsAre(0.9, 1.1));
  EXPECT_THAT(gaps({.where = "status = 'ok' or gap_mm = 0.9", .order_by = "mass_g", .descending = true}),
              ::testing::ElementsAre(0.9, 1.1, 0.7));
  EXPECT_THAT(gaps({.order_by = "grip N", .descending = true}), ::testing::ElementsAre(1.1, 0.7));
  EXPECT_THAT(gaps({.order_by = "mass_g", .most = 1}), ::testing::ElementsAre(0.7));
  EXPECT_EQ(reader.sample(2, "1").back().id, 3);
  EXPECT_EQ(reader.sample(5, "mass_g > 61").size(), 2U);
  EXPECT_EQ(error_text([&] { gaps({.where = "mas_g > 61"}); }), "no such column: mas_g");
  EXPECT_EQ(error_text([&] { gaps({.order_by = "mas_g"}); }), "no such column: mas_g");
  EXPECT_THAT(error_text([&] { gaps({.where = "mass_g >"}); }), HasSubstr("syntax error"));
}

TEST_F(Archive, NumbersDesignsAndEndsRuns) {
  create(path_, contents());
  {
    Writer writer(path_, 60, {});
    writer.add(design(0.7, 60, 1));
    writer.add(design(0.8, 61, 1));
    writer.flush();
    writer.number({{1, 2}});
    EXPECT_EQ(Reader(path_).runs().at(0).ended, "");
  }
  {
    Writer writer(path_, std::nullopt, {});
    writer.add(design(0.9, 62, 1));
    writer.flush();
    writer.number({{2, 1}, {3, 2}});
    writer.end({.stop_reason = "complete", .evaluated = 1, .answered = 2, .reused = 3});
  }
  const Reader reader(path_);
  EXPECT_EQ(reader.row(1)->number, std::nullopt);
  EXPECT_EQ(reader.row(3)->number, 2U);
  EXPECT_EQ(reader.row(3)->run, 2);
  const std::vector<archive::Run> runs = reader.runs();
  ASSERT_EQ(runs.size(), 2U);
  EXPECT_EQ(runs[0].max_evaluations, 60U);
  EXPECT_EQ(runs[0].ended, "");
  EXPECT_EQ(runs[1].max_evaluations, std::nullopt);
  EXPECT_EQ(runs[1].stop_reason, "complete");
  EXPECT_EQ(runs[1].ended.size(), std::string("2026-01-31T12:00:00Z").size());
  EXPECT_EQ((std::vector{runs[1].evaluated, runs[1].answered, runs[1].reused}), (std::vector<std::size_t>{1, 2, 3}));
}

// A connection of another process that has locked the file until it is closed.
std::unique_ptr<sqlite3, decltype(&sqlite3_close)> lock_of(const std::filesystem::path& path) {
  sqlite3* other = nullptr;
  EXPECT_EQ(sqlite3_open(path.c_str(), &other), SQLITE_OK);
  EXPECT_EQ(sqlite3_exec(other, "BEGIN IMMEDIATE", nullptr, nullptr, nullptr), SQLITE_OK);
  return {other, &sqlite3_close};
}

TEST_F(Archive, WritesWhatWaitedForALockAndSaysSoTwice) {
  create(path_, contents());
  std::vector<std::string> told;
  const auto tell = [&](const std::string& line) { told.push_back(line); };
  auto writer = std::make_unique<Writer>(path_, 60, tell, std::chrono::milliseconds(50));
  writer->add(design(1, 60, 1));
  writer->flush();
  auto lock = lock_of(path_);
  for (const double gap : {2.0, 3.0}) {
    writer->add(design(gap, 61, 1));
    writer->flush();
  }
  const std::string refusal = path_.string() + ": cannot be written: database is locked";
  EXPECT_EQ(writer->failure(), refusal + "; designs that are not recorded: 2");
  writer->end({.stop_reason = "converged"});  // not with designs missing
  lock.reset();
  while (writer->failure()) std::this_thread::sleep_for(std::chrono::milliseconds(10));  // of itself
  writer->flush();
  EXPECT_THAT(told, ::testing::ElementsAre(refusal + "; the run goes on, and what waits to be recorded is tried again",
                                           path_.string() + ": is written again, with all that waited"));
  lock = lock_of(path_);
  writer->add(design(4, 62, 1));
  writer.reset();  // it ends though the lock stays
  const Reader reader(path_);
  ASSERT_EQ(reader.size(), 3U);
  reader.each({}, [](const Row& row) { EXPECT_EQ(row.variables.front(), Value(static_cast<double>(row.id))); });
  EXPECT_EQ(reader.runs().at(0).ended, "");
}

int refuse_lock(int /*file*/, int /*command*/, ...) {
  errno = ENOLCK;
  return -1;
}

// SQLite takes such a lock for one that another holds, and asks for it again and again.
TEST_F(Archive, WaitsForNoLockOfAFileSystemThatRefusesThem) {
  create(path_, contents());
  Writer writer(path_, 60, {});
  sqlite3_vfs* system = sqlite3_vfs_find(nullptr);
  const sqlite3_syscall_ptr fcntl = system->xGetSystemCall(system, "fcntl");
  system->xSetSystemCall(system, "fcntl", reinterpret_cast<sqlite3_syscall_ptr>(&refuse_lock));
  const auto begin = std::chrono::steady_clock::now();
  const std::string refusal = ": cannot be written: its file system refuses locks: take a folder on another disk";
  const std::filesystem::path other = folder_.path() / "other.sqlite";
  EXPECT_THAT([&] { create(other, contents()); },
              ::testing::ThrowsMessage<text::OutputError>(other.string() + refusal));
  EXPECT_EQ(this->refusal(), "cannot be read: its file system refuses locks: take a folder on another disk");
  writer.add(design(1, 60, 1));
  writer.flush();
  EXPECT_EQ(writer.failure(), path_.string() + refusal + "; designs that are not recorded: 1");
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(5));  // of SQLite's patience of 10 s each
  system->xSetSystemCall(system, "fcntl", fcntl);
  while (writer.failure()) std::this_thread::sleep_for(std::chrono::milliseconds(10));  // of itself
  EXPECT_EQ(Reader(path_).size(), 1U);
}

TEST_F(Archive, IsOneFileWhenItsWriterIsGone) {
  write({design(0.7, 60, 1)});
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder_.path()))
    names.insert(entry.path().filename().string());
  EXPECT_THAT(names, ::testing::ElementsAre("archive.sqlite"));
}

TEST_F(Archive, RefusesWhatIsNoneOrTooNew) {
  EXPECT_EQ(refusal(), "cannot be read: there is no such file");
  folder_.file("archive.sqlite", "precious notes, and no archive at all");
  EXPECT_EQ(refusal(), "is no archive of a study, or a torn one: file is not a database" + cure);
  std::filesystem::remove(path_);
  execute("CREATE TABLE notes (text)");
  EXPECT_EQ(refusal(), "is no archive of a study: another program wrote it, or it is torn" + cure);
  write({});
  execute("PRAGMA user_version = 4");
  EXPECT_EQ(refusal(),
            "was written by a later coilwright: it is an archive of version 4, and this program reads up to version 3");
  EXPECT_THROW(Writer(path_, 60, {}), text::InputError);
}

// What SQLite would run of itself when the file is read or written to.
TEST_F(Archive, RefusesAViewATriggerAndWhateverElseIsNotItsOwn) {
  const std::string endless = "WITH RECURSIVE c(x) AS (SELECT 1 UNION ALL SELECT x + 1 FROM c) SELECT x FROM c";
  for (const auto& [sql, other] : std::vector<std::pair<std::string, std::string>>{
           {"CREATE VIEW more AS " + endless, "view more"},
           {"ALTER TABLE runs RENAME TO r; DROP TABLE r; CREATE VIEW runs AS " + endless, "view runs"},
           {"CREATE TRIGGER late AFTER INSERT ON runs BEGIN DELETE FROM designs; END", "trigger late"},
           {"CREATE TABLE notes (text)", "table notes"},
           {"CREATE INDEX quick ON designs (abs(mass_g))", "index quick"}}) {
    write({design(0.7, 60, 1.5)});
    execute(sql);
    EXPECT_EQ(refusal(),
              "is no archive of a study: it must have no more than the tables that coilwright makes, and has \"" +
                  other + "\"")
        << sql;
    EXPECT_THROW(Writer(path_, 60, {}), text::InputError) << sql;
    EXPECT_THROW((void)repair_designs(path_, {}, {}), text::InputError) << sql;
  }
}

TEST_F(Archive, EndsAConditionThatHasNoEnd) {
  write({design(0.7, 60, 1.5)});
  const Reader reader(path_);
  const std::string endless =
      "mass_g IN (WITH RECURSIVE c(x) AS (SELECT 1 UNION ALL SELECT x + 1 FROM c) SELECT -x FROM c WHERE x < 0)";
  const auto error = [&](const std::string& where) {
    return error_text([&] { reader.each({.where = where}, [](const Row&) {}); });
  };
  EXPECT_EQ(error(endless), "takes too long, or has no end");
  EXPECT_EQ(error("abs(-9223372036854775807 - 1) > 0"), "integer overflow");
  EXPECT_THROW((void)reader.count(endless), std::invalid_argument);
  EXPECT_EQ(reader.count("mass_g < 70"), 1U);  // the next one has all its steps again
}

const KeepsOn to_the_end = [](std::size_t, std::size_t) { return true; };

// Another value of any column, also one that SQLite has no reason to doubt. What an evaluation gives is mended by one.
TEST_F(Archive, KnowsAChangedValueAndMendsTheDesignOrTakesItOut) {
  using Ids = std::vector<std::int64_t>;
  const std::string advice = "the command that made it makes it anew with --force";
  const auto again = [](const Contents& found, const Row&) {
    EXPECT_EQ(found, contents());
    return std::optional(design(0.9, 61, 1.25).evaluation);
  };
  for (const char* change : {"objective_1 = 61.00000000000001", "mass_g = -60.0", "\"grip N\" = NULL",
                             "failure = 'none'", "status = 'failed'", "gap_mm = 0.8", "configuration = 'A'", "run = 2",
                             "number = 7", "took_s = 0.25", "checksum = checksum + 1", "id = 9"}) {
    const bool is_mended = std::set<char>{'o', 'm', '"', 'f', 's'}.contains(change[0]);
    write({design(0.7, 60, 1.5), design(0.9, 61, 1.25)});
    EXPECT_EQ(refusal(), "") << change;
    execute(std::string("UPDATE designs SET ") + change + " WHERE id = 2");
    const std::string row = std::string(change) == "id = 9" ? "9" : "2";
    EXPECT_EQ(refusal(), "is damaged (row " + row +
                             " of designs is not what was written): coilwright archive check DIR --repair evaluates "
                             "such designs anew, or " +
                             advice)
        << change;
    const Repair repair = repair_designs(path_, again, to_the_end);
    EXPECT_EQ(repair.mended, is_mended ? 1U : 0U) << change;
    EXPECT_EQ(repair.gone, 0) << change;
    EXPECT_EQ(repair.dropped, is_mended ? Ids{} : Ids{std::stoll(row)}) << change;
    EXPECT_EQ(refusal(), "") << change;
    EXPECT_EQ(Reader(path_).size(), is_mended ? 2U : 1U) << change;
    execute("UPDATE designs SET mass_g = 0 WHERE id = 1");
    EXPECT_EQ(repair_designs(path_, again, to_the_end).dropped, Ids{1}) << "what gives other numbers mends nothing";
  }
  for (const char* change : {"study SET seed = 8", "inputs SET content = 'x'", "changes SET change = 'gap_mm=2'",
                             "columns SET meaning = 'm'", "runs SET evaluated = 7"}) {
    write({design(0.7, 60, 1.5)});
    execute(std::string("UPDATE ") + change);
    EXPECT_THAT(refusal(), ::testing::AllOf(HasSubstr("is not what was written"), ::testing::EndsWith("): " + advice)))
        << change;
    EXPECT_THROW((void)repair_designs(path_, again, to_the_end), text::InputError) << change;
  }
}

Row under_beam(double gap) {
  Row row = design(gap, 58, 1.0);
  row.choice = "hinge: beam";
  return row;
}

// Rows that are gone leave no checksum behind that fails.
TEST_F(Archive, MissesRowsThatAreGoneAndIsGoneOnWithAfterARepair) {
  const std::vector<Row> rows{design(0.7, 60, 1.5), design(0.8, 61, 1.25), under_beam(0.7), under_beam(0.8)};
  for (const std::string table : {"designs", "other_choices"}) {
    write(rows);
    execute("DELETE FROM " + table + " WHERE id = 2");
    EXPECT_EQ(refusal(), "is damaged (" + table +
                             " has 1 rows, and 2 were written): coilwright archive check DIR --repair evaluates such "
                             "designs anew, or the command that made it makes it anew with --force");
    const Repair repair = repair_designs(path_, {}, to_the_end);
    EXPECT_EQ(repair.gone, 1);
    EXPECT_EQ(repair.looked_at(), 0U);
    EXPECT_EQ(refusal(), "");
  }
  for (const char* rest : {"study", "inputs WHERE position = 2", "changes", "columns WHERE position = 6", "runs"}) {
    write(rows);
    execute(std::string("DELETE FROM ") + rest);
    EXPECT_NE(refusal(), "") << rest;
    EXPECT_THROW((void)repair_designs(path_, {}, to_the_end), text::InputError) << rest;
  }
  write(rows);
  execute("UPDATE recorded SET rows = 7 WHERE name = 'designs'");
  EXPECT_THAT(refusal(), HasSubstr("of recorded is not what was written): coilwright archive check DIR --repair"));
  EXPECT_EQ(repair_designs(path_, {}, to_the_end).gone, 0) << "what the table said is not known";
  EXPECT_EQ(refusal(), "");
}

TEST_F(Archive, KeepsWhatIsMendedWhereARepairIsStopped) {
  write({design(0.7, 60, 1.5), design(0.8, 60, 1.5), under_beam(0.7)});
  execute("UPDATE designs SET mass_g = 0; UPDATE other_choices SET mass_g = 0");
  const auto again = [](const Contents&, const Row& row) {
    return std::optional((row.choice.empty() ? design(0.7, 60, 1.5) : under_beam(0.7)).evaluation);
  };
  for (const std::size_t left : {2U, 1U, 0U}) {
    const Repair repair = repair_designs(path_, again, [](std::size_t done, std::size_t) { return done < 1; });
    EXPECT_EQ(repair.mended, 1U);
    EXPECT_EQ(repair.left, left);
    EXPECT_EQ(refusal().empty(), left == 0);
  }
  EXPECT_EQ(Reader(path_).find(under_beam(0.7).variables, "hinge: beam")->evaluation, under_beam(0.7).evaluation);
}

TEST_F(Archive, KeepsDesignsUnderOtherChoicesApart) {
  write({design(0.7, 60, 1.5), under_beam(0.7), under_beam(0.9)});
  const Reader reader(path_);
  EXPECT_EQ(reader.size(), 1U);
  EXPECT_EQ(reader.count("1"), 1U);
  const std::vector<Value> variables = under_beam(0.7).variables;
  EXPECT_EQ(reader.find(variables)->evaluation, design(0.7, 60, 1.5).evaluation);
  EXPECT_EQ(reader.find(variables, "hinge: beam")->evaluation, under_beam(0.7).evaluation);
  EXPECT_EQ(reader.find(variables, "hinge: slot"), std::nullopt);
  EXPECT_EQ(reader.find(under_beam(0.9).variables), std::nullopt);
}

TEST_F(Archive, OfVersionTwoIsReadAndGoneOnWith) {
  write({design(0.7, 60, 1.5)});
  execute("DROP TABLE recorded; DROP TABLE other_choices; PRAGMA user_version = 2");
  EXPECT_EQ(Reader(path_).find(under_beam(0.7).variables, "hinge: beam"), std::nullopt);
  {
    Writer writer(path_, 60, {});
    writer.add(under_beam(0.7));
  }
  EXPECT_EQ(Reader(path_).size(), 1U);
  EXPECT_NE(Reader(path_).find(under_beam(0.7).variables, "hinge: beam"), std::nullopt);
  execute("DELETE FROM designs");
  EXPECT_NE(refusal(), "");
}

// What an archive says: its contents, its runs and every row, one after the other.
std::string told_by(const std::filesystem::path& path) {
  const Reader reader(path);
  std::string out = reader.contents() == contents() ? "same contents" : "other contents";
  for (const Run& run : reader.runs()) out += run.started + run.ended + run.stop_reason + std::to_string(run.evaluated);
  const auto tell = [&](const Row& row) {
    out += std::to_string(row.id) + ' ' + std::to_string(row.run) + std::to_string(row.number.value_or(0));
    for (const Value& value : row.variables)
      out += std::holds_alternative<double>(value)
                 ? std::to_string(std::bit_cast<std::uint64_t>(std::get<double>(value)))
                 : std::get<std::string>(value);
    for (const double value : row.evaluation.objectives) out += std::to_string(std::bit_cast<std::uint64_t>(value));
    for (const auto& value : row.evaluation.quantities)
      out += value ? std::to_string(std::bit_cast<std::uint64_t>(*value)) : "none";
  };
  reader.each({}, tell);
  for (int i = 0; i < 20; ++i)
    if (const auto row = reader.find(under_beam(0.5 + 0.01 * i).variables, "hinge: beam")) tell(*row);
  return out;
}

TEST_F(Archive, NeverSaysAnythingElseWhereverAByteOfItIsChanged) {
  std::vector<Row> rows;
  for (int i = 0; i < 20; ++i) rows.push_back(under_beam(0.5 + 0.01 * i));
  for (int i = 0; i < 120; ++i)
    rows.push_back(design(0.5 + 0.01 * i, 60.0 + i / 7.0, i % 5 == 0 ? std::nullopt : std::optional(i / 3.0)));
  write(rows);
  const std::string said = told_by(path_);
  std::string bytes;
  {
    std::ifstream file(path_, std::ios::binary);
    bytes.assign(std::istreambuf_iterator<char>(file), {});
  }
  random_draw::Generator random(17);
  std::size_t refused = 0;
  for (int attempt = 0; attempt < 1000; ++attempt) {
    std::string changed = bytes;
    const std::size_t place = random() % bytes.size();
    changed.at(place) = static_cast<char>(changed[place] ^ (1 << (attempt % 8)));
    std::ofstream(path_, std::ios::binary) << changed;
    try {
      EXPECT_EQ(told_by(path_), said) << "byte " << place << ", bit " << attempt % 8;
    } catch (const text::InputError&) {
      ++refused;
    }
  }
  std::printf("1000 flipped bits: %zu refused, none answered from\n", refused);
  EXPECT_GT(refused, 300U);  // the rest lies where nothing is kept
}

TEST_F(Archive, OfBeforeThereWereChecksumsIsReadAndNotAddedTo) {
  write({design(0.7, 60, 1.5)});
  for (const char* table : {"study", "inputs", "changes", "columns", "runs", "designs"})
    execute(std::string("ALTER TABLE ") + table + " DROP COLUMN checksum");
  execute("DROP TABLE recorded; DROP TABLE other_choices; PRAGMA user_version = 1");
  const Reader reader(path_);
  EXPECT_FALSE(reader.has_checksums());
  EXPECT_EQ(reader.size(), 1U);
  EXPECT_EQ(reader.row(1)->evaluation, design(0.7, 60, 1.5).evaluation);
  EXPECT_THROW(Writer(path_, 60, {}), text::InputError);
}

TEST_F(Archive, IsNotCreatedWhereNothingCanBeWritten) {
  EXPECT_THROW(create(folder_.path() / "none" / "archive.sqlite", contents()), text::OutputError);
}

}  // namespace
}  // namespace coilwright::archive
