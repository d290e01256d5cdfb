#include "page/summary_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "coilwright/text/input_error.hpp"
#include "coilwright/text/input_text.hpp"
#include "coilwright/text/json/document.hpp"

namespace coilwright::page {

namespace {

std::filesystem::path summary_in(const std::filesystem::path& folder) {
  std::filesystem::path file = folder / "summary.txt";
  if (!std::filesystem::is_regular_file(file))
    throw text::InputError({.file = file.string(), .rule = "must be there: diagnose writes it beside diagnosis.json"});
  return file;
}

}  // namespace

std::vector<std::string> summary_section(const std::filesystem::path& folder, std::string_view heading) {
  const std::filesystem::path file = summary_in(folder);
  std::istringstream lines(text::read_text(file, text::json_size_limit).text);
  std::string line;
  while (std::getline(lines, line) && !heading.empty() && line != heading) {
  }
  if (!lines)
    throw text::InputError(
        {.file = file.string(),
         .rule = heading.empty() ? "must not be empty" : fmt::format("must have the section \"{}\"", heading)});
  std::vector<std::string> out;
  while (std::getline(lines, line)) {
    if (line.empty() && !out.empty()) break;
    if (!line.empty()) out.push_back(line);
  }
  if (out.empty() && heading.empty())
    throw text::InputError({.file = file.string(), .rule = "must say the verdict below its title"});
  return out;
}

std::vector<std::string> summary_lines(const std::filesystem::path& folder, std::string_view heading) {
  std::vector<std::string> out = summary_section(folder, heading);
  for (std::string& line : out) line.erase(0, std::min(line.find_first_not_of(' '), line.size()));
  return out;
}

void require_summary_of(const std::filesystem::path& folder, const std::string& dataset, const std::string& verdict) {
  const std::filesystem::path file = summary_in(folder);
  const std::string expected = fmt::format("{}: {}", dataset, verdict);
  const std::string summary = text::read_text(file, text::json_size_limit).text;
  // The name of a data set may have more than one line.
  if (!summary.starts_with(expected + '\n'))
    throw text::InputError({.file = file.string(),
                            .rule = fmt::format("must begin with \"{}\", as diagnosis.json beside it has it", expected),
                            .value = fmt::format("\"{}\"", summary.substr(0, summary.find('\n')))});
}

}  // namespace coilwright::page
