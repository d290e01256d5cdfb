#include "cli/report_option.hpp"

#include <fmt/format.h>

#include <iostream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/options.hpp"
#include "cli/outputs.hpp"
#include "cli/programs.hpp"
#include "coilwright/results/build_info.hpp"

namespace coilwright::cli {

std::string page_name_complaint(const std::string& name) {
  if (name.empty()) return "must not be empty";
  // So that a slip replaces no records and no script.
  return name.ends_with(".html") ? "" : fmt::format("must end in .html; got \"{}\"", name);
}

void add_report_option(CLI::App& command, bool& wanted) {
  add_flag(command, "--report", wanted, fmt::format("Write a page to look at as well: {} in that folder", report_name))
      ->check([](const std::string&) { return results::why_no_page(); });
}

void add_report_file_option(CLI::App& command, std::optional<std::string>& file, bool& force) {
  add_force_option(command, force);
  command.add_option("--report", file, "HTML file for a page to look at and to pass on, that works without a network")
      ->check([](const std::string& name) {
        if (name == "-") return std::string("must be a file: standard output has the answer itself");
        const std::string complaint = page_name_complaint(name);
        return complaint.empty() ? results::why_no_page() : complaint;
      });
}

void write_report(const std::filesystem::path& folder, bool force) {
  const std::filesystem::path file = folder / report_name;
  std::vector<std::string> arguments{"report", "--out=" + file.string()};
  if (force) arguments.emplace_back("--force");
  arguments.insert(arguments.end(), {"--", folder.string()});
  std::cerr << run_program("page", arguments).errors;
}

}  // namespace coilwright::cli
