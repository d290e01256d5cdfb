#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace coilwright::cli {

/// The name of the page in a folder of results.
inline constexpr const char* report_name = "report.html";

/// Up to here, near its beginning, every page of this program is the same.
inline constexpr std::string_view page_mark = "'nonce-";

/// What is wrong with a name for a page; empty where nothing is.
[[nodiscard]] std::string page_name_complaint(const std::string& name);

/// --report of a command that writes a folder, alone or with the name of a file: "" is the page in that folder. Where
/// the program was built without what pages are drawn with, giving it is an error of usage, before any work.
void add_report_option(CLI::App& command, std::optional<std::string>& page);

/// --report FILE of a command that writes no folder; likewise. `force`: its --force.
void add_report_file_option(CLI::App& command, std::optional<std::string>& file, bool& force);

/// Before the work: throws where a page of that name could not be written, or would replace what is no page. The work
/// makes `folder`, in which a page may lie.
void require_page(const std::optional<std::string>& page, const std::filesystem::path& folder, bool force);

/// The page of a folder of results, if one was asked for, written as a whole or not at all; `force` replaces a file of
/// its name that is no page. Throws std::runtime_error with what coilwright-page says where it does not.
void write_report(const std::optional<std::string>& page, const std::filesystem::path& folder, bool force);

/// Arguments in which the name of a page stands with its option, `--report=page.html`, as a value that may be left out
/// must: what follows --report is one if it ends in .html or is the name of nothing that is there.
[[nodiscard]] std::vector<std::string> with_named_pages(std::span<const char* const> arguments);

}  // namespace coilwright::cli
