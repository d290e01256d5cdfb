#pragma once

#include <CLI/CLI.hpp>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "coilwright/page/page.hpp"

namespace coilwright::cli {

/// The name of the page in a folder of results.
inline constexpr const char* report_name = "report.html";

/// Up to here, near its beginning, every page of this program is the same.
inline constexpr std::string_view page_mark = "'nonce-";

/// What is wrong with a name for a page; empty where nothing is.
[[nodiscard]] std::string page_name_complaint(const std::string& name);

/// --report of a command that writes a folder. Where the program was built without what pages are drawn with, giving it
/// is an error of usage, before any work.
void add_report_option(CLI::App& command, bool& wanted);

/// --report FILE of a command that writes no folder; likewise. `force`: its --force.
void add_report_file_option(CLI::App& command, std::optional<std::string>& file, bool& force);

/// What a page may be told.
struct ReportOptions {
  std::optional<std::size_t> pictures{};  ///< designs of a front that are drawn and simulated at most (default 200)
  std::optional<std::filesystem::path> figures{};  ///< folder for every figure as a file of its own
  bool force{false};                               ///< replace a file that is no page, and figures of other content
};

/// The page of a folder of results, written to `file` as a whole or not at all. Figures that cannot be drawn without
/// Node are named on standard error. Throws InputError where the folder has no results or the program was built without
/// what pages are drawn with, OutputError where a file cannot be written.
void write_report(const std::filesystem::path& folder, const std::filesystem::path& file,
                  const ReportOptions& options = {});

/// A page written to `file` as a whole or not at all, and each of its figures into a folder, if one is given.
void write_page(const page::Page& content, const std::filesystem::path& file, const ReportOptions& options = {});

}  // namespace coilwright::cli
