#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <span>
#include <string>

#include "coilwright/text/json/json.hpp"

namespace coilwright::cli {

/// --json of a command that writes files.
void add_written_json_option(CLI::App& command, bool& json);

/// {"files": ["results/step.csv"]}: what a command wrote, to print.
[[nodiscard]] text::Json written_json(std::span<const std::filesystem::path> files);

/// Throws CLI::ValidationError where --json is asked for and `out` is standard output, which cannot hold both.
void require_file_for_json(bool json, const std::string& out);

}  // namespace coilwright::cli
