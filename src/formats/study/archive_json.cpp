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
      objectives.set(column.name, number_of(row.evaluation, column.role, objective++));
    if (column.role == Role::constraint)
      constraints.set(column.name, number_of(row.evaluation, column.role, constraint++));
    if (column.role == Role::quantity) quantities.set(column.name, number_of(row.evaluation, column.role, quantity++));
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

}  // namespace coilwright::formats
