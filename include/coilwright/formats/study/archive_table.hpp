#pragma once

#include <ostream>

#include "coilwright/archive/contents.hpp"
#include "coilwright/archive/row.hpp"
#include "coilwright/text/csv/csv_writer.hpp"

namespace coilwright::formats {

/// The designs of an archive as CSV, row by row: row, run, number, status, the variables, the objectives and limits
/// under the names of their columns in the archive, every quantity, reason, took_s.
class ArchiveTable {
 public:
  /// Writes the header. The stream must outlive the table.
  ArchiveTable(std::ostream& out, archive::Contents contents);

  /// Writes one design.
  void row(const archive::Row& row);

 private:
  archive::Contents contents_;
  text::CsvWriter csv_;
};

}  // namespace coilwright::formats
