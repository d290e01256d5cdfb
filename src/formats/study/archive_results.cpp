#include "coilwright/formats/study/archive_results.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "coilwright/formats/study/design_tables.hpp"

namespace coilwright::formats {
namespace {

using archive::Column;
using archive::Contents;
using archive::Role;
using archive::Row;
using text::Json;
using text::text_or_null;

Json run_json(const archive::Run& run) {
  return Json::object({{"run", run.id},
                       {"started_utc", run.started},
                       {"ended_utc", text_or_null(run.ended)},
                       {"stop_reason", text_or_null(run.stop_reason)},
                       {"max_evaluations", run.max_evaluations},
                       {"evaluated", run.evaluated},
                       {"answered", run.answered},
                       {"reused", run.reused}});
}

Json program_json(const archive::Program& program) {
  return Json::object({{"version", program.version},
                       {"commit", text_or_null(program.commit)},
                       {"build_sha256", text_or_null(program.build)}});
}

// What a design has in a column of numbers; nothing where it has none.
struct Number {
  const Column& column;
  std::optional<double> value{};
};

std::vector<Number> numbers_of(const Contents& contents, const sizing::Evaluation& evaluation) {
  std::vector<Number> out;
  std::array<std::size_t, 4> met{};  // columns of each role
  for (const Column& column : contents.columns) {
    const std::size_t index = met.at(static_cast<std::size_t>(column.role))++;
    if (column.role == Role::variable) continue;
    Number& number = out.emplace_back(Number{.column = column});
    const std::vector<double>& values = column.role == Role::objective ? evaluation.objectives : evaluation.constraints;
    if (column.role != Role::quantity && index < values.size()) number.value = values[index];
    if (column.role == Role::quantity && index < evaluation.quantities.size())
      number.value = evaluation.quantities[index];
  }
  return out;
}

// By the name of the column in the table, which is there once.
Json row_json(const Contents& contents, const Row& row) {
  Json variables = Json::object(), quantities = Json::object(), objectives = Json::object(),
       constraints = Json::object();
  std::size_t variable = 0;
  for (const Column& column : contents.columns)
    if (column.role == Role::variable)
      std::visit([&](const auto& value) { variables.set(column.name, value); }, row.variables.at(variable++));
  for (const Number& each : numbers_of(contents, row.evaluation)) {
    const Role role = each.column.role;
    Json& out = role == Role::objective ? objectives : role == Role::constraint ? constraints : quantities;
    out.set(each.column.name, each.value);
  }
  return Json::object({{"row", row.id},
                       {"run", row.run},
                       {"number", row.number},
                       {"status", status_of(row.evaluation)},
                       {"reason", text_or_null(row.evaluation.failure)},
                       {"variables", std::move(variables)},
                       {"objectives", std::move(objectives)},
                       {"constraints", std::move(constraints)},
                       {"quantities", std::move(quantities)},
                       {"took_s", row.seconds},
                       {"reused_from", text_or_null(row.origin)}});
}

std::string digits(const std::optional<double>& value) {
  return value ? fmt::format("{}", *value) : "none";
}

std::vector<std::string> names_of(const archive::Contents& contents) {
  std::vector<std::string> names{"row", "run", "number", "status"};
  for (const archive::Column& column : contents.columns) names.push_back(column.column);
  names.insert(names.end(), {"reason", "took_s"});
  return names;
}

}  // namespace

std::vector<Difference> differences(const Replay& replay) {
  std::vector<Difference> found;
  if (replay.recorded.failure != replay.again.failure)
    found.push_back({.name = "failure",
                     .recorded = replay.recorded.failure.empty() ? "none" : replay.recorded.failure,
                     .again = replay.again.failure.empty() ? "none" : replay.again.failure});
  if (replay.recorded.infeasibility != replay.again.infeasibility)
    found.push_back({.name = "infeasibility",
                     .recorded = digits(replay.recorded.infeasibility),
                     .again = digits(replay.again.infeasibility)});
  const std::vector<Number> recorded = numbers_of(replay.contents, replay.recorded),
                            again = numbers_of(replay.contents, replay.again);
  for (std::size_t i = 0; i < recorded.size(); ++i)
    if (recorded[i].value != again[i].value)
      found.push_back(
          {.name = recorded[i].column.name, .recorded = digits(recorded[i].value), .again = digits(again[i].value)});
  return found;
}

Json to_json(const ArchiveSummary& summary) {
  const Contents& contents = summary.contents;
  Json inputs = Json::list(contents.inputs, [](const archive::Input& input) {
    return Json::object({{"file", input.file}, {"sha256", input.sha256}});
  });
  Json columns = Json::list(contents.columns, [](const Column& column) {
    return Json::object({{"column", column.column}, {"role", archive::name_of(column.role)}, {"name", column.name}});
  });
  return Json::object(
      {{"command", contents.command},
       {"study", contents.study},
       {"program", program_json(contents.program)},
       {"inputs", std::move(inputs)},
       {"set", Json::list(contents.changes)},
       {"question_sha256", contents.question},
       {"algorithm", text_or_null(contents.algorithm)},
       {"seed", contents.seed},
       {"designs", Json::object({{"ok", summary.ok}, {"infeasible", summary.infeasible}, {"failed", summary.failed}})},
       {"runs", Json::list(summary.runs, run_json)},
       {"columns", std::move(columns)}});
}

Json to_json(const Contents& contents, std::span<const Row> rows) {
  return Json::object({{"designs", Json::list(rows, [&](const Row& row) { return row_json(contents, row); })}});
}

Json to_json(const Replay& replay) {
  Json found = Json::list(differences(replay), [](const Difference& each) {
    return Json::object({{"name", each.name}, {"recorded", each.recorded}, {"again", each.again}});
  });
  return Json::object({{"row", replay.row},
                       {"same", replay.recorded == replay.again},
                       {"written_by", program_json(replay.contents.program)},
                       {"this_program", program_json(replay.program)},
                       {"differences", std::move(found)}});
}

ArchiveTable::ArchiveTable(std::ostream& out, archive::Contents contents)
    : contents_(std::move(contents)), csv_(out, names_of(contents_)) {}

void ArchiveTable::row(const archive::Row& row) {
  const sizing::Evaluation& evaluation = row.evaluation;
  std::vector<text::CsvCell> cells{row.id, row.run, row.number ? text::CsvCell(*row.number) : text::CsvCell(),
                                   status_of(evaluation)};
  for (const archive::Value& value : row.variables)
    std::visit([&](const auto& each) { cells.emplace_back(each); }, value);
  for (const Number& each : numbers_of(contents_, evaluation)) cells.emplace_back(each.value);
  cells.emplace_back(evaluation.failure);
  cells.emplace_back(row.seconds);
  csv_.row(cells);
}

}  // namespace coilwright::formats
