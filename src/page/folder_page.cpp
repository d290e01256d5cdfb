#include <algorithm>
#include <utility>
#include <variant>

#include "coilwright/page/chart.hpp"
#include "coilwright/page/pages.hpp"
#include "coilwright/text/input_error.hpp"
#include "coilwright/text/json/document.hpp"
#include "page/result_pages.hpp"
#include "page/result_words.hpp"

namespace coilwright::page {
namespace {

constexpr const char* diagnosis_name = "diagnosis.json";

struct BlockOf {
  Block operator()(const report::BarChart& chart) const { return figure_of(chart); }
  Block operator()(const auto& block) const { return block; }
};

Page page_of(const std::filesystem::path& folder, const std::filesystem::path& file, const text::Node& result,
             const PageInputs& inputs) {
  result.expect_object();
  const auto command = result.find("command");
  const std::string word = command && command->kind() == text::Node::Kind::text ? command->text() : "";
  if (file.filename() == diagnosis_name) return diagnosis_page(folder, result, inputs.made_by);
  if (word == "size") return sizing_page(folder, result, inputs.made_by);
  if (word == "pareto") return front_page(folder, result, inputs);
  if (word == "sweep") return sweep_page(folder, result, inputs);
  throw text::InputError({.file = file.string(),
                          .place = "/command",
                          .rule = "must be \"size\", \"pareto\" or \"sweep\": there is no page of other results",
                          .value = command ? command->shown() : ""});
}

}  // namespace

Page page_of(const report::Document& document, std::string origin, std::vector<std::string> inputs) {
  Page page{.title = document.title,
            .verdict = document.verdict,
            .cautions = document.cautions,
            .origin = std::move(origin),
            .inputs = std::move(inputs)};
  for (const report::Section& section : document.sections) {
    if (section.blocks.empty()) continue;
    page.sections.push_back({.id = section.id, .title = section.title});
    for (const auto& block : section.blocks) page.sections.back().blocks.push_back(std::visit(BlockOf{}, block));
  }
  return page;
}

Page page_of(const std::filesystem::path& folder, const text::Node& result, std::string_view made_by) {
  const auto summary = result.find("summary");
  if (!summary)
    throw result.error_without_value(
        R"(must have "summary" (docs/formats.md), which an earlier version did not write: run it again)");
  return page_of(report::read_document(*summary), origin_text(folder, made_by), input_lines(folder));
}

Section& section_named(Page& page, std::string_view id, std::string_view title) {
  const auto found = std::ranges::find(page.sections, id, &Section::id);
  if (found != page.sections.end()) return *found;
  return page.sections.emplace_back(Section{.id = std::string(id), .title = std::string(title)});
}

Page page_of(const std::filesystem::path& folder, const PageInputs& inputs) {
  if (!std::filesystem::is_directory(folder))
    throw text::InputError({.file = folder.string(), .rule = "must be a folder of results"});
  if (std::filesystem::is_regular_file(folder / "result.json") &&
      std::filesystem::is_regular_file(folder / diagnosis_name))
    throw text::InputError({.file = folder.string(),
                            .rule = "has the results of two runs, result.json and diagnosis.json: move one of them, "
                                    "with what belongs to it, to a folder of its own"});
  for (const char* name : {"result.json", diagnosis_name}) {
    const std::filesystem::path file = folder / name;
    if (!std::filesystem::is_regular_file(file)) continue;
    const text::Document document = text::read_json(file);
    return page_of(folder, file, document.root(), inputs);
  }
  if (std::filesystem::is_regular_file(folder / "archive.sqlite"))
    throw text::InputError(
        {.file = folder.string(),
         .rule =
             "has no result yet: its run was killed or is under way; the same command with --resume goes on with it"});
  throw text::InputError(
      {.file = folder.string(),
       .rule = "has neither result.json nor diagnosis.json: it is no folder of size, sweep, pareto or diagnose"});
}

}  // namespace coilwright::page
