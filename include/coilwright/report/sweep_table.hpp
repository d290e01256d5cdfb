#pragma once

#include <iosfwd>
#include <span>
#include <string>

#include "coilwright/report/csv_writer.hpp"
#include "coilwright/sizing/leaders.hpp"

namespace coilwright::report {

/// The designs of a sweep as CSV, written as they come: the variables, `status` (ok, infeasible, failed), every
/// quantity that `evaluate` prints, the margin of every limit, `reason` of a failed one.
class SweepTable {
 public:
  /// `out` and `study` must outlive it.
  SweepTable(std::ostream& out, const sizing::Study& study);
  void row(const sizing::SweptDesign& design);

 private:
  const sizing::Study* study_;
  CsvWriter csv_;
  std::vector<CsvCell> cells_;
};

/// The leaders of a sweep as CSV: `best_for` (the objective), then the columns of SweepTable.
void write_leaders(std::ostream& out, const sizing::Study& study, std::span<const sizing::Leader> leaders);

/// The leaders as a table to read: configuration, objective, variables, objectives, and what is in the way where
/// nothing is feasible.
[[nodiscard]] std::string leaders_text(const sizing::Study& study, std::span<const sizing::Leader> leaders);

}  // namespace coilwright::report
