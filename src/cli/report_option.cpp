#include "cli/report_option.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "cli/options.hpp"
#include "cli/outputs.hpp"
#include "cli/programs.hpp"
#include "coilwright/results/build_info.hpp"

namespace coilwright::cli {

namespace {

constexpr std::string_view alone = "true";  // what CLI11 gives a flag without a value

}  // namespace

std::string page_name_complaint(const std::string& name) {
  if (name.find_first_not_of(' ') == std::string::npos) return "must not be empty";
  // So that a slip replaces no records and no script.
  return name.ends_with(".html") ? "" : fmt::format("must end in .html; got \"{}\"", name);
}

void add_report_option(CLI::App& command, std::optional<std::string>& page) {
  const auto complaint = [](const std::string& name) {
    const std::string wrong = name == alone ? "" : page_name_complaint(name);
    return wrong.empty() ? results::why_no_page() : wrong;
  };
  auto given = std::make_shared<std::string>();
  command
      .add_flag("--report", *given,
                fmt::format("Write a page to look at as well: {} in that folder, or, as --report FILE.html, that file",
                            report_name))
      ->check(complaint)
      ->each([&page, given](const std::string& name) { page = name == alone ? "" : name; });
}

void add_report_file_option(CLI::App& command, std::optional<std::string>& file, bool& force) {
  add_force_option(command, force);
  command.add_option("--report", file, "HTML file for a page to look at and to pass on, that works without a network")
      ->type_name("FILE.html")
      ->check([](const std::string& name) {
        if (name == "-") return std::string("must be a file: standard output has the answer itself");
        const std::string complaint = page_name_complaint(name);
        return complaint.empty() ? results::why_no_page() : complaint;
      });
}

void require_page(const std::optional<std::string>& page, const std::filesystem::path& folder, bool force) {
  if (!page || page->empty()) return;
  const auto plain = [](const std::filesystem::path& path) { return (path / "").lexically_normal(); };
  std::error_code none;
  if (std::filesystem::exists(folder, none) || plain(std::filesystem::path(*page).parent_path()) != plain(folder))
    require_writable({*page});
  if (!force && std::filesystem::exists(*page, none) && !has_mark(*page, page_mark)) throw other_content(*page);
}

void write_report(const std::optional<std::string>& page, const std::filesystem::path& folder, bool force) {
  if (!page) return;
  const std::filesystem::path file = page->empty() ? folder / report_name : std::filesystem::path(*page);
  std::vector<std::string> arguments{"report", "--out=" + file.string()};
  if (force) arguments.emplace_back("--force");
  arguments.insert(arguments.end(), {"--", folder.string()});
  std::cerr << run_program("page", arguments).errors;
}

std::vector<std::string> with_named_pages(std::span<const char* const> arguments) {
  constexpr std::string_view option = "--report";
  const auto is_page = [](std::string_view name) {
    std::error_code none;
    return name == "-" || name.ends_with(".html") ||
           !(name.starts_with('-') || std::filesystem::exists(std::filesystem::path(name), none));
  };
  std::vector<std::string> out;
  for (const std::string_view each : arguments)
    if (!out.empty() && out.back() == option && is_page(each))
      out.back() += fmt::format("={}", each);
    else  // a flag of CLI11 does not tell an empty value from none, but a blank one
      out.push_back(fmt::format("{}{}", each, each == "--report=" ? " " : ""));
  return out;
}

}  // namespace coilwright::cli
