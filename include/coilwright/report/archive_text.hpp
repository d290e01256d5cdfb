#pragma once

#include <span>
#include <string>

#include "coilwright/formats/study/archive_results.hpp"

namespace coilwright::report {

/// The subject of an archive, its designs by status, and its runs as a table.
[[nodiscard]] std::string to_text(const formats::ArchiveSummary& summary);

/// Designs as a table: row, number, status, variables, objectives and, if it is none of these, the requested column;
/// then why a design failed.
[[nodiscard]] std::string to_text(const archive::Contents& contents, std::span<const archive::Row> rows,
                                  const std::string& further_column);

/// Whether a design gives the same numbers again; if not, the differences and the programs.
[[nodiscard]] std::string to_text(const formats::Replay& replay);

}  // namespace coilwright::report
