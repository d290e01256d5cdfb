#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <functional>
#include <iostream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "coilwright/text/json/json.hpp"
#include "coilwright/text/output/output_file.hpp"
#include "coilwright/text/output/output_folder.hpp"

namespace coilwright::cli {

/// Throws text::OutputError naming the first of `outputs` that is one of `inputs`, as writing it would lose it, or that
/// is there and cannot be replaced, as a folder: before the work.
void keep_inputs(const std::vector<std::filesystem::path>& inputs, const std::vector<std::filesystem::path>& outputs);

/// Throws text::OutputError naming the first of these files that cannot be written: before the work. An empty name is
/// no file.
void require_writable(const std::vector<std::filesystem::path>& files);

/// An option --force of a command that calls keep_others() or one of the other functions below.
void add_force_option(CLI::App& command, bool& force);

/// That a file is there which only --force replaces.
[[nodiscard]] text::OutputError other_content(const std::filesystem::path& file);

/// Throws text::OutputError naming the first file of `folder` that has another content than was written for it so far,
/// unless `force`: records of a laboratory have the names of a data set's, too. The same command again changes nothing.
void keep_others(text::OutputFolder& folder, bool force);

/// The same of a single file.
void keep_other(text::OutputFile& file, bool force);

/// The same of a file that is made again and again with other contents: what begins like it, up to the end of the first
/// `mark`, may be replaced.
void keep_other_kind(text::OutputFile& file, std::string_view mark, bool force);
/// Writes such a file as a whole by `write`, or not at all.
void write_file(const std::filesystem::path& path, std::string_view mark, bool force,
                const std::function<void(std::ostream&)>& write);

/// Marks of the files that begin alike: a table by its header, JSON by its first key.
inline constexpr std::string_view table_mark = "\n";
inline constexpr std::string_view json_mark = ",\n";

/// The same of a table that is made again and again: what begins with the header of these columns may be replaced.
void keep_other_table(const text::OutputFile& file, std::span<const std::string> columns, bool force);

/// Whether a file has `mark` near its beginning, as one that an earlier run of this program wrote.
[[nodiscard]] bool has_mark(const std::filesystem::path& file, std::string_view mark);

/// Throws text::OutputError where the folder has a provenance.json that no run wrote, unless `force`.
void keep_other_provenance(const std::filesystem::path& folder, bool force);

/// --json of a command that writes files.
void add_written_json_option(CLI::App& command, bool& json);

/// {"files": ["results/step.csv"]}: what a command wrote, to print.
[[nodiscard]] text::Json written_json(const std::vector<std::filesystem::path>& files);

/// Throws CLI::ValidationError where --json is asked for and `out` is standard output, which cannot hold both.
void require_file_for_json(bool json, const std::string& out);

/// A path fit for a line of a terminal, whatever is in its names; never cut.
[[nodiscard]] std::string printed(const std::filesystem::path& path);

/// Where a command tells of its results: standard output or, where "-" puts one of its files there, standard error.
[[nodiscard]] inline std::ostream& report_stream(std::string_view file, std::string_view another_file = {}) {
  return file == "-" || another_file == "-" ? std::cerr : std::cout;
}

}  // namespace coilwright::cli
