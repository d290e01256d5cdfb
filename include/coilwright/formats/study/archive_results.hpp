#pragma once

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "coilwright/archive/contents.hpp"
#include "coilwright/archive/row.hpp"
#include "coilwright/text/csv/csv_writer.hpp"
#include "coilwright/text/json/json.hpp"

namespace coilwright::formats {

/// The subject of an archive, and its runs.
struct ArchiveSummary {
  archive::Contents contents;      ///< of the archive
  std::vector<archive::Run> runs;  ///< runs, in their order
  std::size_t ok{};                ///< designs that keep every limit
  std::size_t infeasible{};        ///< designs that break one
  std::size_t failed{};            ///< designs that could not be evaluated
};

/// A design of an archive, evaluated again.
struct Replay {
  std::int64_t row{};           ///< id of the design
  sizing::Evaluation recorded;  ///< evaluation in the archive
  sizing::Evaluation again;     ///< evaluation by this program
  archive::Contents contents;   ///< of the archive
  archive::Program program;     ///< this program
};

/// A number that differs at the second evaluation.
struct Difference {
  std::string name;      ///< "mass_g", "mass_g <= 70", "failure"
  std::string recorded;  ///< recorded value with every digit; "none" if there is none
  std::string again;     ///< new value with every digit; "none" if there is none
};

/// All differences, in the order of the archive's columns; empty if every bit is the same.
[[nodiscard]] std::vector<Difference> differences(const Replay& replay);

/// An archive's study, program and runs.
[[nodiscard]] text::Json to_json(const ArchiveSummary& summary);

/// Designs with all values that an archive has of them.
[[nodiscard]] text::Json to_json(const archive::Contents& contents, std::span<const archive::Row> rows);

/// Whether the numbers are the same, and both if they are not.
[[nodiscard]] text::Json to_json(const Replay& replay);

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
