#pragma once

#include <iosfwd>

#include "coilwright/sizing/problem/archive.hpp"

namespace coilwright::formats {

/// How a search came to its answer, as CSV: what was best after so many evaluations (`evaluation`).
///
/// With one objective `best_NAME`, the best feasible value so far, a row for each improvement and the last evaluation.
/// With several `front_size` and `hypervolume` of the front so far, normalised by the final front (ideal 0, nadir 1,
/// reference 1.1), at some 200 evenly spaced evaluations. Both have `least_violation`: the least sum of broken limits,
/// each relative to its limit, 0 once a design is feasible; empty while every design failed.
void write_convergence(std::ostream& out, const sizing::Archive& archive);

}  // namespace coilwright::formats
