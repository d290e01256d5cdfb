#include "page/result_pages.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "coilwright/page/chart.hpp"
#include "coilwright/report/simulation/percent.hpp"
#include "coilwright/text/input_error.hpp"
#include "page/result_words.hpp"
#include "page/run_figures.hpp"

namespace coilwright::page {
namespace {

using text::Node;

// Samples of runs in one role that errors are taken of, in all quantities.
std::size_t samples_of(const Node& diagnosis, const char* role) {
  const auto errors = member_of(diagnosis, "error").find(role);
  if (!errors) return 0;
  std::size_t out = 0;
  if (const auto main = errors->find("samples")) out += main->integer<std::size_t>();
  for (const Node& each : errors->members())
    if (each.kind() == Node::Kind::object)
      if (const auto other = each.find("samples")) out += other->integer<std::size_t>();
  return out;
}

// A table that was cut, or is of another diagnosis, would show other runs than those of the verdict.
void require_all_samples(const std::filesystem::path& folder, const Node& diagnosis,
                         const std::vector<RunRecord>& records) {
  for (const char* role : {"fit", "validate"}) {
    std::size_t there = 0;
    for (const RunRecord& each : records)
      if (each.role == role) there += each.measured.size() - each.outliers;
    const std::size_t counted = samples_of(diagnosis, role);
    if (there != counted)
      throw text::InputError(
          {.file = (folder / "residuals.csv").string(),
           .rule =
               fmt::format("must have the {} samples of role {} that diagnosis.json beside it counts", counted, role),
           .value = fmt::format("{}", there)});
  }
}

std::vector<Section> runs_sections(const std::filesystem::path& folder, const Node& diagnosis) {
  Section held{.id = "held", .title = "Runs that no fit has seen"};
  Section fitted{.id = "fitted", .title = "Runs that were fitted"};
  std::size_t number = 0;
  const std::vector<RunRecord> records = read_runs(folder);
  require_all_samples(folder, diagnosis, records);
  for (const RunRecord& record : records) {
    ++number;
    std::vector<Block>& blocks = record.role == "fit" ? fitted.blocks : held.blocks;
    for (Figure& figure : run_figures(record, number)) blocks.emplace_back(std::move(figure));
  }
  std::vector<Section> sections;
  if (!held.blocks.empty()) sections.push_back(std::move(held));
  if (!fitted.blocks.empty()) sections.push_back(std::move(fitted));
  return sections;
}

// "angle, deg" from the key "at_deg" of the variable "angle".
std::string variable_title(const std::string& variable, const std::string& key) {
  return key == "at" ? variable : fmt::format("{}, {}", variable, key.substr(3));
}

void add_dependences(Page& page, const Node& diagnosis) {
  const auto residual = diagnosis.find("residual");
  if (!residual || residual->is_null()) return;
  const std::vector<Node> dependences = member_of(*residual, "dependences").elements();
  if (dependences.empty()) return;
  Section& section = section_named(page, "leftover", "What is left over, as a joint torque");
  std::size_t number = 0;
  for (const Node& each : dependences) {
    const std::string variable = member_of(each, "variable").text();
    Series series{.name = "residual torque", .y = member_of(each, "residual_Nmm").numbers(), .mark = Mark::points};
    std::string title = variable;
    for (const Node& member : each.members()) {
      if (!member.key().starts_with("at")) continue;
      series.x = member.numbers();
      title = variable_title(variable, member.key());
    }
    if (series.x.size() != series.y.size() || series.x.empty()) continue;
    Series joined = series;
    joined.name = "between its means";
    joined.mark = Mark::line;
    section.blocks.emplace_back(figure_of(
        Chart{.id = fmt::format("dependence-{}", ++number),
              .title = fmt::format("Residual torque over {}", variable),
              .description = fmt::format("Means in bins of as many samples each; {} explains {:.3g} % of the residual.",
                                         variable, 100.0 * member_of(each, "explained").number()),
              .x_title = title,
              .y_title = "residual torque, N mm",
              .series = {std::move(joined), std::move(series)}}));
  }
}

// What the summary leaves out: every hypothesis, and those that have no probability.
Section candidates_section(const Node& diagnosis) {
  Section section{.id = "candidates", .title = "All hypotheses"};
  Table table{.header = {"rank", "effects", "probability", "log evidence", "residual", "leaves noise"}};
  const auto samples = static_cast<double>(samples_of(diagnosis, "fit"));
  const auto shown = [](const Node& probability) {
    return probability.is_null() ? "-" : report::probability_text(probability.number());
  };
  for (const Node& each : member_of(diagnosis, "candidates").elements()) {
    const Node left = member_of(each, "chi_square");
    const bool is_told = !left.is_null() && samples > 0.0;
    table.rows.push_back({fmt::format("{}", table.rows.size() + 1), ids_text(member_of(each, "effects")),
                          shown(member_of(each, "probability")), cell_of(each, "log_evidence"),
                          is_told ? short_number(std::sqrt(left.number() / samples)) : "-",
                          shown(member_of(each, "probability_of_noise"))});
  }
  if (!table.rows.empty())
    section.blocks.emplace_back(TableBlock{.caption = "Hypotheses, most probable first; log evidence is the natural "
                                                      "logarithm, over that of no effect",
                                           .table = std::move(table)});
  Table ruled_out{.header = {"effects", "why it has no probability"}};
  for (const Node& each : member_of(diagnosis, "ruled_out").elements())
    ruled_out.rows.push_back({ids_text(member_of(each, "effects")), member_of(each, "remark").text()});
  if (!ruled_out.rows.empty())
    section.blocks.emplace_back(TableBlock{.caption = "Not compared", .table = std::move(ruled_out)});
  return section;
}

// What a diagnosis may say (docs/formats-diagnosis.md).
constexpr std::array<std::string_view, 6> verdicts{"no_missing_effect", "declared_numbers_off", "explained",
                                                   "partly_explained",  "unexplained",          "incomplete"};

}  // namespace

Page diagnosis_page(const std::filesystem::path& folder, const Node& diagnosis, std::string_view made_by) {
  const Node verdict = member_of(diagnosis, "verdict");
  if (std::ranges::find(verdicts, verdict.text()) == verdicts.end())
    throw verdict.error(fmt::format("must be one of {}", fmt::join(verdicts, ", ")));
  if (verdict.text() == "incomplete")
    throw verdict.error_without_value(
        "is of a diagnosis that was interrupted: summary.txt has what was known then, and there is a page once it has "
        "ended (diagnose again)");
  Page page = page_of(folder, diagnosis, made_by);
  add_dependences(page, diagnosis);
  add_next_experiment(page, folder, diagnosis);
  for (Section& section : runs_sections(folder, diagnosis)) page.sections.push_back(std::move(section));
  page.sections.push_back(candidates_section(diagnosis));
  return page;
}

}  // namespace coilwright::page
