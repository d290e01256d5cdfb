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

/// The status of a design: "ok", "infeasible" or "failed".
[[nodiscard]] std::string_view status_of(const sizing::Evaluation& evaluation);

/// Column of a limit's margin: "mass_max_margin_g" for mass_g <= 70, "steady_angle_min_margin_deg" for >=.
[[nodiscard]] std::string margin_column(const sizing::Limit& limit);

/// Suffix of the unit of a difference of two values of a quantity: "K" for degC; empty for a plain number.
[[nodiscard]] std::string_view difference_unit(const simulation::ResultQuantity& quantity);

/// Whether the study has a variable of that name.
[[nodiscard]] bool is_variable(const sizing::Study& study, std::string_view name);

/// The margin of a limit, in the unit of its quantity, from the constraint's value.
[[nodiscard]] double margin_of(const sizing::Limit& limit, double constraint);

/// The value of a limit's quantity, from the constraint's value.
[[nodiscard]] double value_behind(const sizing::Limit& limit, double constraint);

/// Writes every evaluated design as CSV, a row each in the order given: the variables, `evaluation` (its place in the
/// order of evaluation, from 1), `status` (ok, infeasible, failed), every quantity of the study's table, objectives
/// that the table lacks, the margin of every limit in its quantity's unit, and the `reason` of a failed one.
void write_evaluations(std::ostream& out, const sizing::Study& study, std::span<const sizing::Record> records);

/// Writes a front as CSV, a row for each design in the order given: the variables, the objectives, the margin of every
/// limit, and every other quantity of the study's table.
void write_front(std::ostream& out, const sizing::Study& study, std::span<const sizing::Record> front);

/// Writes one design of a sweep.
using SweepRow = std::function<void(const sizing::SweptDesign&)>;

/// Writes the header of the designs of a sweep as CSV, and returns the function that writes a row: the variables,
/// `status` (ok, infeasible, failed), every quantity that `evaluate` prints, the margin of every limit, and the
/// `reason` of a failed one. `out` and `study` must outlive that function.
[[nodiscard]] SweepRow write_sweep(std::ostream& out, const sizing::Study& study);

/// Writes the leaders of a sweep as CSV: `best_for` (the objective), then the columns of write_sweep().
void write_leaders(std::ostream& out, const sizing::Study& study, std::span<const sizing::Leader> leaders);

/// Writes the progress of a search as CSV: the best result after each number of evaluations (`evaluation`).
///
/// With one objective it has `best_NAME`, the best feasible value up to there, in a row for each improvement and for
/// the last evaluation. With several it has `front_size` and `hypervolume` of the front up to there, normalised by the
/// final front (ideal 0, nadir 1, reference 1.1), at some 200 evenly spaced evaluations. Both have `least_violation`,
/// the least sum of broken limits, each relative to its limit: 0 once a design is feasible, empty while every design
/// failed.
void write_convergence(std::ostream& out, const sizing::Archive& archive);

}  // namespace coilwright::formats
