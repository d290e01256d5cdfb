#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <span>
#include <string>

#include "coilwright/text/output/output_file.hpp"
#include "coilwright/text/output/output_folder.hpp"

namespace coilwright::cli {

/// Throws text::OutputError naming the first of `outputs` that is one of `inputs`: writing it would lose it.
void keep_inputs(std::span<const std::filesystem::path> inputs, std::span<const std::filesystem::path> outputs);

/// An option --force of a command that calls keep_others() or keep_other().
void add_force_option(CLI::App& command, bool& force);

/// Throws text::OutputError naming the first file of `folder` that has another content than was written for it so far,
/// unless `force`: records of a laboratory have the names of a data set's, too. The same command again changes nothing.
void keep_others(text::OutputFolder& folder, bool force);

/// The same of a single file.
void keep_other(text::OutputFile& file, bool force);

/// The same of a table that is made again and again: what begins with the header of these columns may be replaced.
void keep_other_table(const text::OutputFile& file, std::span<const std::string> columns, bool force);

}  // namespace coilwright::cli
