#pragma once

#include <functional>
#include <iosfwd>
#include <ostream>
#include <span>
#include <string>
#include <string_view>

#include "coilwright/sizing/problem/archive.hpp"
#include "coilwright/sizing/study/design_problem.hpp"
#include "coilwright/sizing/study/leaders.hpp"
#include "coilwright/sizing/study/study.hpp"
#include "coilwright/sizing/study/sweep.hpp"

namespace coilwright::formats {

/// "ok", "infeasible" or "failed".
[[nodiscard]] std::string_view status_of(const sizing::Evaluation& evaluation);

/// Column of a limit's margin: "mass_max_margin_g" for mass_g <= 70, "steady_angle_min_margin_deg" for >=.
[[nodiscard]] std::string margin_column(const sizing::Limit& limit);

/// Suffix of the unit of a difference of two values of a quantity: "K" for degC; empty for a plain number.
[[nodiscard]] std::string_view difference_unit(const simulation::ResultQuantity& quantity);

/// Whether the study has a variable of that name.
[[nodiscard]] bool is_variable(const sizing::Study& study, std::string_view name);

/// The margin behind a constraint's value, in the unit of its quantity.
[[nodiscard]] double margin_of(const sizing::Limit& limit, double constraint);

/// The value that a limit's quantity has, given the constraint's.
[[nodiscard]] double value_behind(const sizing::Limit& limit, double constraint);

/// Every evaluated design as CSV, a row each in the order given: the variables as a study writes them, `evaluation`
/// (its place in the order of evaluation, from 1), `status` (ok, infeasible, failed), every quantity of the study's
/// table, objectives that the table lacks, the margin of every limit in its quantity's unit, `reason` of a failed one.
void write_evaluations(std::ostream& out, const sizing::Study& study, std::span<const sizing::Record> records);

/// A front as CSV, a row a design in the order given: the variables, the objectives, the margin of every limit, and
/// then every other quantity of the study's table.
void write_front(std::ostream& out, const sizing::Study& study, std::span<const sizing::Record> front);

/// Writes one design of a sweep.
using SweepRow = std::function<void(const sizing::SweptDesign&)>;

/// The designs of a sweep as CSV, written as they come: the variables, `status` (ok, infeasible, failed), every
/// quantity that `evaluate` prints, the margin of every limit, `reason` of a failed one. Writes the header, and returns
/// what writes a row. `out` and `study` must outlive that.
[[nodiscard]] SweepRow write_sweep(std::ostream& out, const sizing::Study& study);

/// The leaders of a sweep as CSV: `best_for` (the objective), then the columns of write_sweep().
void write_leaders(std::ostream& out, const sizing::Study& study, std::span<const sizing::Leader> leaders);

/// How a search came to its answer, as CSV: what was best after so many evaluations (`evaluation`).
///
/// With one objective `best_NAME`, the best feasible value so far, a row for each improvement and the last evaluation.
/// With several `front_size` and `hypervolume` of the front so far, normalised by the final front (ideal 0, nadir 1,
/// reference 1.1), at some 200 evenly spaced evaluations. Both have `least_violation`: the least sum of broken limits,
/// each relative to its limit, 0 once a design is feasible; empty while every design failed.
void write_convergence(std::ostream& out, const sizing::Archive& archive);

}  // namespace coilwright::formats
