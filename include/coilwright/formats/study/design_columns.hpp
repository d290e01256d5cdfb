#pragma once

#include <cstddef>
#include <functional>
#include <iosfwd>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "coilwright/sizing/study/design_problem.hpp"
#include "coilwright/text/csv/csv_writer.hpp"

namespace coilwright::formats {

/// A design of a study, as tables have it.
struct DesignRow {
  std::span<const double> point;
  const sizing::Evaluation& evaluation;
  std::size_t number{};         ///< its place in the order of evaluation
  std::string_view best_for{};  ///< the objective in which it leads
};

/// A column of a table of designs: its name, and what it has of each.
struct DesignColumn {
  std::string name;
  std::function<text::CsvCell(const DesignRow&)> cell;
};
using DesignColumns = std::vector<DesignColumn>;

/// A table of designs, written row by row.
class DesignTable {
 public:
  /// Writes the header. The stream, and the study that the columns are of, must outlive it.
  DesignTable(std::ostream& out, DesignColumns columns);
  /// Writes the row of one design.
  void row(const DesignRow& row);

 private:
  DesignColumns columns_;
  text::CsvWriter csv_;
  std::vector<text::CsvCell> cells_;
};

/// "ok", "infeasible" or "failed".
[[nodiscard]] std::string_view status_of(const sizing::Evaluation& evaluation);

/// Column of a limit's margin: "mass_max_margin_g" for mass_g <= 70, "steady_angle_min_margin_deg" for >=.
[[nodiscard]] std::string margin_column(const sizing::Limit& limit);

/// Suffix of the unit of a difference of two values of a quantity: "K" for degC; empty for a plain number.
[[nodiscard]] std::string_view difference_unit(const simulation::ResultQuantity& quantity);

/// The names of the variables, in their order.
void add_variable_names(const sizing::Study& study, std::vector<std::string>& names);

/// The same as columns.
void add_variables(const sizing::Study& study, DesignColumns& columns);
/// Objectives that are not variables too (current_A may be both).
void add_objectives(const sizing::Study& study, DesignColumns& columns);
/// Every quantity of the study's table that is not a variable too; empty where a design has no value.
void add_quantities(const sizing::Study& study, DesignColumns& columns);
/// Margins in the units of their quantities, negative where a limit is broken; empty for a failed design.
void add_margins(const sizing::Study& study, DesignColumns& columns);
/// One objective; empty for a failed design.
void add_objective(const sizing::Study& study, std::size_t index, DesignColumns& columns);
/// One quantity of the study's table.
void add_quantity(const sizing::Study& study, std::size_t index, DesignColumns& columns);
/// "status", and "reason" of a failed design.
void add_status(DesignColumns& columns);
void add_reason(DesignColumns& columns);

/// Whether the study has a variable of that name.
[[nodiscard]] bool is_variable(const sizing::Study& study, std::string_view name);

/// The margin behind a constraint's value, in the unit of its quantity.
[[nodiscard]] double margin_of(const sizing::Limit& limit, double constraint);

/// The value that a limit's quantity has, given the constraint's.
[[nodiscard]] double value_behind(const sizing::Limit& limit, double constraint);

}  // namespace coilwright::formats
