#pragma once

#include <iosfwd>
#include <span>

#include "coilwright/sizing/problem/archive.hpp"
#include "coilwright/sizing/study/study.hpp"

namespace coilwright::formats {

/// Every evaluated design as CSV, a row each in the order given: the variables as a study writes them, `evaluation`
/// (its place in the order of evaluation, from 1), `status` (ok, infeasible, failed), every quantity of the study's
/// table, objectives that the table lacks, the margin of every limit in its quantity's unit, `reason` of a failed one.
void write_evaluations(std::ostream& out, const sizing::Study& study, std::span<const sizing::Record> records);

/// A front as CSV, a row a design in the order given: the variables, the objectives, the margin of every limit, and
/// then every other quantity of the study's table.
void write_front(std::ostream& out, const sizing::Study& study, std::span<const sizing::Record> front);

}  // namespace coilwright::formats
