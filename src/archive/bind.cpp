#include "archive/bind.hpp"

#include <algorithm>
#include <stdexcept>

namespace coilwright::archive {
namespace {

std::string_view status_of(const sizing::Evaluation& evaluation) {
  if (!evaluation.failure.empty()) return "failed";
  return sizing::is_feasible(evaluation) ? "ok" : "infeasible";
}

Value value_of(const SQLite::Column& cell) {
  if (cell.isText()) return cell.getString();
  return cell.getDouble();
}

}  // namespace

void bind_row(SQLite::Statement& insertion, Designs table, const Row& row, std::int64_t id, std::int64_t run) {
  const sizing::Evaluation& evaluation = row.evaluation;
  const bool failed = !evaluation.failure.empty();
  Binder binder(insertion);
  insertion.clearBindings();  // what is not bound is NULL
  binder.integer(id).integer(run).integer(row.number).text(status_of(evaluation));
  failed ? binder.lasting(evaluation.failure) : binder.none();
  binder.number(evaluation.infeasibility).integer(evaluation.quantities.empty() ? 0 : 1);
  binder.number(row.seconds).number(row.ended);
  row.origin.empty() ? binder.none() : binder.lasting(row.origin);
  const std::size_t choices = table == Designs::of_the_study ? 0 : 1;
  if (choices > 0) binder.lasting(row.choice);
  for (const Value& value : row.variables) {
    if (const auto* number = std::get_if<double>(&value))
      binder.number(*number);
    else
      binder.lasting(std::get<std::string>(value));
  }
  // The archive's columns are as many as the study has, also where a design has no numbers.
  const int places = insertion.getBindParameterCount();
  const auto fixed = static_cast<int>(fixed_columns.size() + choices + row.variables.size());
  int place = fixed;
  if (!failed) {
    for (const double value : evaluation.objectives) insertion.bind(++place, value);
    for (const double value : evaluation.constraints) insertion.bind(++place, value);
  }
  place = places - static_cast<int>(evaluation.quantities.size());
  for (const std::optional<double>& value : evaluation.quantities) {
    ++place;
    if (value) insertion.bind(place, *value);
  }
}

ColumnCounts counts_of(Designs table, const std::vector<Column>& columns) {
  const auto count = [&](Role role) {
    return static_cast<std::size_t>(std::ranges::count(columns, role, &Column::role));
  };
  return {.choices = table == Designs::of_the_study ? 0U : 1U,
          .variables = count(Role::variable),
          .objectives = count(Role::objective),
          .constraints = count(Role::constraint),
          .quantities = count(Role::quantity)};
}

Row row_of(const SQLite::Statement& selected, const ColumnCounts& counts) {
  Row row;
  int i = 0;
  const auto cell = [&] { return selected.getColumn(i++); };
  row.id = cell().getInt64();
  row.run = cell().getInt64();
  if (const SQLite::Column number = cell(); !number.isNull()) row.number = static_cast<std::size_t>(number.getInt64());
  ++i;  // the status follows from the rest
  row.evaluation.failure = cell().getString();
  row.evaluation.infeasibility = cell().getDouble();
  const bool has_quantities = cell().getInt() != 0;
  if (const SQLite::Column seconds = cell(); !seconds.isNull()) row.seconds = seconds.getDouble();
  row.ended = cell().getDouble();
  row.origin = cell().getString();
  if (counts.choices > 0) row.choice = cell().getString();
  for (std::size_t k = 0; k < counts.variables; ++k) row.variables.push_back(value_of(cell()));
  const bool failed = !row.evaluation.failure.empty();
  const auto numbers = [&](std::size_t count, std::vector<double>& out) {
    for (std::size_t k = 0; k < count; ++k) {
      const double value = cell().getDouble();
      if (!failed) out.push_back(value);
    }
  };
  numbers(counts.objectives, row.evaluation.objectives);
  numbers(counts.constraints, row.evaluation.constraints);
  if (!has_quantities) return row;
  for (std::size_t k = 0; k < counts.quantities; ++k) {
    const SQLite::Column value = cell();
    row.evaluation.quantities.push_back(value.isNull() ? std::nullopt : std::optional(value.getDouble()));
  }
  return row;
}

}  // namespace coilwright::archive
