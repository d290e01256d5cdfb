#include "coilwright/report/archive_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "coilwright/formats/study/design_tables.hpp"
#include "coilwright/report/simulation/text_table.hpp"

namespace coilwright::report {
namespace {

using archive::Column;
using archive::Contents;
using archive::Role;
using archive::Row;
using enum TextTable::Align;

std::string text_of(const archive::Value& value) {
  if (const auto* number = std::get_if<double>(&value)) return short_number(*number);
  return std::get<std::string>(value);
}

std::string text_of(const std::vector<double>& values, std::size_t index) {
  return index < values.size() ? short_number(values[index]) : "-";
}

std::string text_of(const std::vector<std::optional<double>>& values, std::size_t index) {
  return index < values.size() && values[index] ? short_number(*values[index]) : "-";
}

std::string count_or_dash(const std::optional<std::size_t>& count) {
  return count ? fmt::format("{}", *count) : "-";
}

std::string runs_text(const std::vector<archive::Run>& runs) {
  TextTable table;
  table.row({"run", "began", "ended", "why", "budget", "evaluated", "known", "reused"});
  for (const archive::Run& run : runs) {
    // What a run has done is written where it ends: one that was killed has not said it.
    const bool ended = !run.ended.empty();
    const auto count = [&](std::size_t value) { return ended ? fmt::format("{}", value) : "-"; };
    table.row({fmt::format("{}", run.id), run.started, ended ? run.ended : "killed, or under way",
               run.stop_reason.empty() ? "-" : run.stop_reason, count_or_dash(run.max_evaluations),
               count(run.evaluated), count(run.answered), count(run.reused)});
  }
  return table.text(0, {right, left, left, left});
}

// Whether the table shows a quantity: the one asked for, unless it is an objective and so there already.
bool is_further(const Contents& contents, const Column& column, const std::string& further_column) {
  if (column.role != Role::quantity || column.column != further_column) return false;
  return std::ranges::none_of(
      contents.columns, [&](const Column& each) { return each.role == Role::objective && each.name == column.name; });
}

bool is_shown(const Contents& contents, const Column& column, const std::string& further_column) {
  return column.role == Role::variable || column.role == Role::objective ||
         is_further(contents, column, further_column);
}

std::vector<std::string> cells_of(const Contents& contents, const Row& row, const std::string& further_column) {
  const sizing::Evaluation& evaluation = row.evaluation;
  std::vector<std::string> cells{fmt::format("{}", row.id), count_or_dash(row.number),
                                 std::string(formats::status_of(evaluation))};
  std::size_t variable = 0, objective = 0, quantity = 0;
  for (const Column& column : contents.columns) {
    const bool shown = is_shown(contents, column, further_column);
    if (column.role == Role::variable) cells.push_back(text_of(row.variables.at(variable++)));
    if (column.role == Role::objective) cells.push_back(text_of(evaluation.objectives, objective++));
    if (column.role != Role::quantity) continue;
    if (shown) cells.push_back(text_of(evaluation.quantities, quantity));
    ++quantity;
  }
  cells.push_back(evaluation.failure);
  return cells;
}

}  // namespace

std::string to_text(const formats::ArchiveSummary& summary) {
  const Contents& contents = summary.contents;
  std::string text =
      fmt::format("{} of \"{}\": {} designs recorded; {} keep every limit, {} break one, {} could not be evaluated.\n",
                  contents.command, contents.study, summary.ok + summary.infeasible + summary.failed, summary.ok,
                  summary.infeasible, summary.failed);
  std::vector<std::string> files;
  for (const archive::Input& input : contents.inputs)
    files.push_back(fmt::format("{} (SHA-256 {:.8})", input.file, input.sha256));
  text += fmt::format("From {}", fmt::join(files, " and "));
  if (!contents.changes.empty()) text += fmt::format(" with --set {}", fmt::join(contents.changes, " --set "));
  if (contents.seed) text += fmt::format("; algorithm {}, seed {}", contents.algorithm, *contents.seed);
  return text + fmt::format(".\nEvaluated by coilwright {}.\n\n", archive::name_of(contents.program)) +
         runs_text(summary.runs);
}

std::string to_text(const Contents& contents, std::span<const Row> rows, const std::string& further_column) {
  if (rows.empty()) return "No design of the archive is so.\n";
  TextTable table;
  std::vector<std::string> header{"row", "number", "status"};
  for (const Column& column : contents.columns)
    if (is_shown(contents, column, further_column)) header.push_back(column.name);
  std::vector<TextTable::Align> align(header.size(), right);
  align.push_back(left);
  header.emplace_back();
  table.row(std::move(header));
  for (const Row& row : rows) table.row(cells_of(contents, row, further_column));
  return table.text(0, std::move(align));
}

std::string to_text(const formats::Replay& replay) {
  const std::vector<formats::Difference> found = formats::differences(replay);
  if (found.empty())
    return fmt::format(
        "Row {} gives the same {} numbers again, to the last bit.\n", replay.row,
        replay.recorded.objectives.size() + replay.recorded.constraints.size() + replay.recorded.quantities.size());
  std::string text =
      fmt::format("Row {} gives other numbers now. Recorded by coilwright {}, evaluated again by {}.\n", replay.row,
                  archive::name_of(replay.contents.program), archive::name_of(replay.program));
  TextTable table;
  table.row({"", "recorded", "again"});
  for (const formats::Difference& each : found) table.row({each.name, each.recorded, each.again});
  return text + table.text(2, {left});
}

}  // namespace coilwright::report
