#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>

#include "coilwright/archive/reader.hpp"
#include "coilwright/sizing/study/design_problem.hpp"

namespace coilwright::cli {

/// DIR, the folder of an archive.
void add_archive_folder(CLI::App& command, std::string& folder);

/// --row, the place of a design in the order of recording.
void add_row_option(CLI::App& command, std::int64_t& row);

/// The archive of a folder of results. Throws InputError.
[[nodiscard]] archive::Reader opened_archive(const std::string& folder);

/// The design of a row. Throws InputError where there is none.
[[nodiscard]] archive::Row row_of(const archive::Reader& archive, std::int64_t row);

/// The study of an archive, from the texts that it keeps. Throws InputError where this program does not take them.
[[nodiscard]] sizing::DesignProblem problem_of(const archive::Contents& contents);

/// The point of a row in the search of its study. Throws InputError where it has none.
[[nodiscard]] std::vector<double> point_of(const sizing::DesignProblem& problem, const archive::Reader& archive,
                                           const archive::Row& row);

}  // namespace coilwright::cli
