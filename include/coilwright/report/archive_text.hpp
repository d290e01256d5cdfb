#pragma once

#include <span>
#include <string>

#include "coilwright/formats/study/archive_results.hpp"

namespace coilwright::report {

/// What an archive is of, its designs by status, and its runs as a table.
[[nodiscard]] std::string to_text(const formats::ArchiveSummary& summary);

/// Designs as a table: row, number, status, variables, objectives and, where it is none of these, the column asked for;
/// behind them why a design failed.
[[nodiscard]] std::string to_text(const archive::Contents& contents, std::span<const archive::Row> rows,
                                  const std::string& further_column);

/// Whether a design gives the same numbers again; where not, which, and by which programs.
[[nodiscard]] std::string to_text(const formats::Replay& replay);

}  // namespace coilwright::report
