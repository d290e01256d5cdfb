#include "coilwright/formats/study/archive_json.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "coilwright/formats/study/design_columns.hpp"

namespace coilwright::formats {
namespace {

using archive::Column;
using archive::Contents;
using archive::Role;
using archive::Row;
using text::Json;

Json text_or_null(const std::string& text) {
  return text.empty() ? Json(nullptr) : Json(text);
}

Json value_or_null(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json run_json(const archive::Run& run) {
  return Json::object({{"run", run.id},
                       {"started_utc", run.started},
                       {"ended_utc", text_or_null(run.ended)},
                       {"stop_reason", text_or_null(run.stop_reason)},
                       {"max_evaluations", run.max_evaluations ? Json(*run.max_evaluations) : Json(nullptr)},
                       {"evaluated", run.evaluated},
                       {"answered", run.answered},
                       {"reused", run.reused}});
}

Json program_json(const archive::Program& program) {
  return Json::object({{"version", program.version},
                       {"commit", text_or_null(program.commit)},
                       {"build_sha256", text_or_null(program.build)}});
}

// The value of a column in a design; nothing where it has none.
std::optional<double> number_of(const sizing::Evaluation& evaluation, Role role, std::size_t index) {
  if (role == Role::quantity) return index < evaluation.quantities.size() ? evaluation.quantities[index] : std::nullopt;
  const std::vector<double>& values = role == Role::objective ? evaluation.objectives : evaluation.constraints;
  return index < values.size() ? std::optional(values[index]) : std::nullopt;
}

// By the name of the column in the table, which is there once.
Json row_json(const Contents& contents, const Row& row) {
  Json variables = Json::object(), quantities = Json::object(), objectives = Json::object(),
       constraints = Json::object();
  std::size_t variable = 0, objective = 0, constraint = 0, quantity = 0;
  for (const Column& column : contents.columns) {
    if (column.role == Role::variable)
      std::visit([&](const auto& value) { variables.set(column.name, value); }, row.variables.at(variable++));
    if (column.role == Role::objective)
      objectives.set(column.name, value_or_null(number_of(row.evaluation, column.role, objective++)));
    if (column.role == Role::constraint)
      constraints.set(column.name, value_or_null(number_of(row.evaluation, column.role, constraint++)));
    if (column.role == Role::quantity)
      quantities.set(column.name, value_or_null(number_of(row.evaluation, column.role, quantity++)));
  }
  return Json::object({{"row", row.id},
                       {"run", row.run},
                       {"number", row.number ? Json(*row.number) : Json(nullptr)},
                       {"status", status_of(row.evaluation)},
                       {"reason", text_or_null(row.evaluation.failure)},
                       {"variables", std::move(variables)},
                       {"objectives", std::move(objectives)},
                       {"constraints", std::move(constraints)},
                       {"quantities", std::move(quantities)},
                       {"took_s", value_or_null(row.seconds)},
                       {"reused_from", text_or_null(row.origin)}});
}

std::string digits(const std::optional<double>& value) {
  return value ? fmt::format("{}", *value) : "none";
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
  std::size_t objective = 0, constraint = 0, quantity = 0;
  for (const Column& column : replay.contents.columns) {
    if (column.role == Role::variable) continue;
    const std::size_t index = column.role == Role::objective    ? objective++
                              : column.role == Role::constraint ? constraint++
                                                                : quantity++;
    const std::optional<double> recorded = number_of(replay.recorded, column.role, index),
                                again = number_of(replay.again, column.role, index);
    if (recorded != again) found.push_back({.name = column.name, .recorded = digits(recorded), .again = digits(again)});
  }
  return found;
}

Json to_json(const ArchiveSummary& summary) {
  const Contents& contents = summary.contents;
  Json inputs = Json::array(), changes = Json::array(), columns = Json::array(), runs = Json::array();
  for (const archive::Input& input : contents.inputs)
    inputs.add(Json::object({{"file", input.file}, {"sha256", input.sha256}}));
  for (const std::string& change : contents.changes) changes.add(change);
  for (const Column& column : contents.columns)
    columns.add(
        Json::object({{"column", column.column}, {"role", archive::name_of(column.role)}, {"name", column.name}}));
  for (const archive::Run& run : summary.runs) runs.add(run_json(run));
  return Json::object(
      {{"command", contents.command},
       {"study", contents.study},
       {"program", program_json(contents.program)},
       {"inputs", std::move(inputs)},
       {"set", std::move(changes)},
       {"question_sha256", contents.question},
       {"algorithm", text_or_null(contents.algorithm)},
       {"seed", contents.seed ? Json(*contents.seed) : Json(nullptr)},
       {"designs", Json::object({{"ok", summary.ok}, {"infeasible", summary.infeasible}, {"failed", summary.failed}})},
       {"runs", std::move(runs)},
       {"columns", std::move(columns)}});
}

Json to_json(const Contents& contents, std::span<const Row> rows) {
  Json out = Json::array();
  for (const Row& row : rows) out.add(row_json(contents, row));
  return Json::object({{"designs", std::move(out)}});
}

Json to_json(const Replay& replay) {
  Json found = Json::array();
  for (const Difference& each : differences(replay))
    found.add(Json::object({{"name", each.name}, {"recorded", each.recorded}, {"again", each.again}}));
  return Json::object({{"row", replay.row},
                       {"same", replay.recorded == replay.again},
                       {"written_by", program_json(replay.contents.program)},
                       {"this_program", program_json(replay.program)},
                       {"differences", std::move(found)}});
}

}  // namespace coilwright::formats
