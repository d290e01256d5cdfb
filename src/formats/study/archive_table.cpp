#include "coilwright/formats/study/archive_table.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "coilwright/formats/study/design_columns.hpp"

namespace coilwright::formats {
namespace {

std::vector<std::string> names_of(const archive::Contents& contents) {
  std::vector<std::string> names{"row", "run", "number", "status"};
  for (const archive::Column& column : contents.columns) names.push_back(column.column);
  names.insert(names.end(), {"reason", "took_s"});
  return names;
}

}  // namespace

ArchiveTable::ArchiveTable(std::ostream& out, archive::Contents contents)
    : contents_(std::move(contents)), csv_(out, names_of(contents_)) {}

void ArchiveTable::row(const archive::Row& row) {
  const sizing::Evaluation& evaluation = row.evaluation;
  std::vector<text::CsvCell> cells{row.id, row.run, row.number ? text::CsvCell(*row.number) : text::CsvCell(),
                                   status_of(evaluation)};
  for (const archive::Value& value : row.variables)
    std::visit([&](const auto& each) { cells.emplace_back(each); }, value);
  std::size_t objective = 0, constraint = 0, quantity = 0;
  const auto add = [&](const std::vector<double>& values, std::size_t index) {
    cells.push_back(index < values.size() ? text::CsvCell(values[index]) : text::CsvCell());
  };
  for (const archive::Column& column : contents_.columns) {
    if (column.role == archive::Role::objective) add(evaluation.objectives, objective++);
    if (column.role == archive::Role::constraint) add(evaluation.constraints, constraint++);
    if (column.role != archive::Role::quantity) continue;
    cells.push_back(quantity < evaluation.quantities.size() ? text::CsvCell(evaluation.quantities[quantity])
                                                            : text::CsvCell());
    ++quantity;
  }
  cells.emplace_back(evaluation.failure);
  cells.emplace_back(row.seconds);
  csv_.row(cells);
}

}  // namespace coilwright::formats
