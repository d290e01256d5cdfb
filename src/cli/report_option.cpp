#include "report_option.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "build_info.hpp"
#include "coilwright/formats/study/study_file.hpp"
#include "coilwright/page/page_html.hpp"
#include "coilwright/page/pages.hpp"
#include "coilwright/text/input_error.hpp"
#include "coilwright/text/json/document.hpp"
#include "coilwright/text/output/output_file.hpp"
#include "coilwright/text/output/output_folder.hpp"
#include "draw_figures.hpp"
#include "options.hpp"
#include "outputs.hpp"
#include "packed_files.hpp"
#include "provenance.hpp"
#include "sha256.hpp"

namespace coilwright::cli {
namespace {

constexpr const char* built_without =
    "this program was built without Vega, which pages are drawn with: install npm and build it again "
    "(cmake -DCOILWRIGHT_REPORT_ASSETS=ON says what is missing)";

std::vector<page::Script> scripts() {
  const std::span<const PackedFile> libraries = report_libraries();
  std::vector<page::Script> out;
  for (const char* name : {"vega.js", "vega-lite.js", "vega-embed.js"})
    out.push_back({.name = name, .text = packed_text(libraries, name), .licence = {}});
  out.front().name = "Vega, Vega-Lite, vega-embed and what they contain";
  out.front().licence = packed_text(libraries, "licences.txt");
  for (const char* name : {"theme.js", "page.js", "front.js"})
    out.push_back({.name = name, .text = packed_text(page_files(), name), .licence = {}});
  return out;
}

text::Node required_member(const text::Node& object, std::string_view key) {
  if (const auto found = object.find(key)) return *found;
  throw object.error_without_value(fmt::format("must have \"{}\" (docs/formats.md)", key));
}

// Whether the file still is what went into a result.
bool is_unchanged(const text::Node& input, std::string& file) {
  file = required_member(input, "file").text();
  std::error_code none;
  if (!std::filesystem::is_regular_file(file, none)) return false;
  return record_of(std::filesystem::path(file)).sha256 == required_member(input, "sha256").text();
}

// The study that the results of a folder are of, by its provenance.json; or why it is not at hand.
void find_study(const std::filesystem::path& folder, page::PageInputs& inputs) {
  const std::filesystem::path provenance = folder / provenance_name;
  if (!std::filesystem::is_regular_file(provenance)) {
    inputs.why_no_study = fmt::format("the folder has no {}, which names the study.", provenance_name);
    return;
  }
  const text::Document document = text::read_json(provenance);
  std::vector<std::string> files;
  for (const text::Node& input : required_member(document.root(), "inputs").elements(text::Length::at_least(1))) {
    if (is_unchanged(input, files.emplace_back())) continue;
    inputs.why_no_study =
        fmt::format("{}, which these results are of, is not there as it was; make the page where the search was run.",
                    files.back());
    return;
  }
  std::vector<std::string> changes;
  for (const text::Node& change : required_member(document.root(), "set").elements()) changes.push_back(change.text());
  try {
    inputs.study = formats::read_study(files.at(0), {.changes = changes});
  } catch (const text::InputError& why) {
    inputs.why_no_study = fmt::format("the study that {} names cannot be read: {}.", provenance.string(), why.what());
  }
}

// Why no page can be made; empty where one can.
std::string why_none() {
  return report_libraries().empty() ? std::string(built_without) : std::string();
}

}  // namespace

std::string made_by() {
  return "coilwright " + version();
}

std::string page_name_complaint(const std::string& name) {
  if (name.empty()) return "must not be empty";
  // So that a slip replaces no records and no script.
  return name.ends_with(".html") ? "" : fmt::format("must end in .html; got \"{}\"", name);
}

void add_report_option(CLI::App& command, bool& wanted) {
  add_flag(command, "--report", wanted, fmt::format("Write a page to look at as well: {} in that folder", report_name))
      ->check([](const std::string&) { return why_none(); });
}

void add_report_file_option(CLI::App& command, std::optional<std::string>& file, bool& force) {
  add_force_option(command, force);
  command.add_option("--report", file, "HTML file for a page to look at and to pass on, that works without a network")
      ->check([](const std::string& name) {
        if (name == "-") return std::string("must be a file: standard output has the answer itself");
        const std::string complaint = page_name_complaint(name);
        return complaint.empty() ? why_none() : complaint;
      });
}

void write_report(const std::filesystem::path& folder, const std::filesystem::path& file,
                  const ReportOptions& options) {
  if (report_libraries().empty()) throw text::InputError({.file = folder.string(), .rule = built_without});
  page::PageInputs inputs{.made_by = made_by()};
  for (const char* of_designs : {"front.csv", "best.csv"})
    if (std::filesystem::is_regular_file(folder / of_designs)) find_study(folder, inputs);
  if (options.pictures) inputs.most_pictures = *options.pictures;
  write_page(page::page_of(folder, inputs), file, options);
}

void write_page(const page::Page& content, const std::filesystem::path& file, const ReportOptions& options) {
  const std::string_view style = packed_text(page_files(), "page.css");
  const std::vector<page::Script> all = scripts();
  text::OutputFile out(file);
  std::optional<text::OutputFolder> figures;
  if (options.figures) {
    DrawnFigures drawn = draw_figures(page::figure_files(content, style));
    figures.emplace(*options.figures);
    for (const page::FigureFile& each : drawn.files) figures->write(each.name, each.text);
    if (!drawn.why.empty()) std::cerr << drawn.why << ".\n";
  }
  out.stream() << page::to_html(content, {.scripts = all, .style = style},
                                [](std::string_view bytes) { return sha256(bytes); });
  constexpr std::string_view page_mark = "'nonce-";  // what follows is of one page alone
  keep_other_kind(out, page_mark, options.force);
  if (figures) {
    keep_others(*figures, options.force);
    out.withdraw();
    figures->commit();
  }
  out.commit();
}

}  // namespace coilwright::cli
