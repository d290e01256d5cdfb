#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "coilwright/text/output/output_file.hpp"
#include "coilwright/text/output/output_folder.hpp"

namespace coilwright::cli {

/// Throws text::OutputError naming the first of `outputs` that is one of `inputs`: writing it would lose it.
void keep_inputs(std::span<const std::filesystem::path> inputs, std::span<const std::filesystem::path> outputs);

/// An option --force of a command that calls keep_others() or one of the other functions below.
void add_force_option(CLI::App& command, bool& force);

/// Throws text::OutputError naming the first file of `folder` that has another content than was written for it so far,
/// unless `force`: records of a laboratory have the names of a data set's, too. The same command again changes nothing.
void keep_others(text::OutputFolder& folder, bool force);

/// The same of a single file.
void keep_other(text::OutputFile& file, bool force);

/// The same of a file that is made again and again with other contents: what begins like it, up to the end of the first
/// `mark`, may be replaced.
void keep_other_kind(text::OutputFile& file, std::string_view mark, bool force);
/// Marks of the files that begin alike: a table by its header, JSON by its first key.
inline constexpr std::string_view table_mark = "\n";
inline constexpr std::string_view json_mark = ",\n";

/// The same of a table that is made again and again: what begins with the header of these columns may be replaced.
void keep_other_table(const text::OutputFile& file, std::span<const std::string> columns, bool force);

/// Throws text::OutputError naming the first of `names` that is in `folder`, unless `force` or an earlier run of the
/// same command wrote it: the first of them is then there and has `mark` near its beginning.
void keep_results_of_others(const std::filesystem::path& folder, std::span<const char* const> names,
                            std::string_view mark, bool force);

}  // namespace coilwright::cli
