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
#include "coilwright/text/input_error.hpp"
#include "page/result_words.hpp"
#include "page/run_figures.hpp"

namespace coilwright::page {
namespace {

using text::Node;

std::string interval_text(const Node& parameter) {
  const auto interval = parameter.find("ci95");
  if (!interval || interval->is_null()) return "-";
  const std::vector<Node> ends = interval->elements();
  if (ends.size() != 2 || (ends[0].is_null() && ends[1].is_null())) return "not determined";
  if (ends[0].is_null()) return "at most " + cell_of(ends[1]);
  if (ends[1].is_null()) return "at least " + cell_of(ends[0]);
  return fmt::format("{} to {}", cell_of(ends[0]), cell_of(ends[1]));
}

// What the fit makes of a declared number: its value, or from where on it changes nothing.
std::string fitted_text(const Node& number) {
  const auto idle_from = number.find("idle_from");
  if (!idle_from) return cell_of(number, "value");
  const bool below = idle_from->number() < member_of(number, "declared").number();
  return fmt::format("{} {}", below ? "below" : "above", cell_of(*idle_from));
}

// What is all but certain is not 1.
std::string probability_text(const Node& number) {
  if (number.is_null()) return "-";
  if (number.number() > 0.999) return "more than 0.999";
  return number.number() < 0.001 ? "less than 0.001" : cell_of(number);
}

Section effects_section(const Node& diagnosis) {
  Section section{.id = "effects", .title = "What the model lacks"};
  Table table{.header = {"effect", "probability", "number", "value", "95 % interval"}};
  for (const Node& effect : member_of(diagnosis, "effects").elements()) {
    const std::string id = member_of(effect, "id").text();
    const auto evidence = effect.find("evidence");
    const auto known = evidence ? evidence->find("probability") : std::nullopt;
    const std::string probability = known ? probability_text(*known) : "-";
    bool first = true;
    const std::vector<Node> parameters = member_of(effect, "parameters").members();
    if (parameters.empty()) table.rows.push_back({id, probability, "", "", ""});
    for (const Node& parameter : parameters) {
      table.rows.push_back({first ? id : "", first ? probability : "", parameter.key(), cell_of(parameter, "value"),
                            interval_text(parameter)});
      first = false;
    }
  }
  if (table.rows.empty())
    section.blocks.emplace_back(Paragraph{"No effect was added to the model."});
  else
    section.blocks.emplace_back(TableBlock{.caption = "Effects, and their numbers", .table = std::move(table)});
  Table moved{.header = {"number", "declared", "now", "95 % interval"}};
  for (const char* key : {"calibration", "nominal"})
    if (const auto numbers = diagnosis.find(key))
      for (const Node& each : numbers->members())
        moved.rows.push_back({each.key(), each.find("declared") ? cell_of(each, "declared") : "-", fitted_text(each),
                              interval_text(each)});
  if (!moved.rows.empty())
    section.blocks.emplace_back(
        TableBlock{.caption = "Declared numbers as the fit has them", .table = std::move(moved)});
  return section;
}

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

// Numbers of one object of errors, without those of other quantities inside of it.
void add_errors(Table& table, const Node& errors, const std::string& runs) {
  for (const auto& [key, name] : model_words) {
    const auto model = errors.find(key);
    if (!model || model->is_null()) continue;
    for (const Node& each : model->members())
      if (each.kind() == Node::Kind::number) table.rows.push_back({runs, std::string(name), each.key(), cell_of(each)});
  }
  for (const Node& each : errors.members())
    if (each.kind() == Node::Kind::number && each.key() != "samples")
      table.rows.push_back({runs, "", each.key(), cell_of(each)});
}

Section errors_section(const Node& diagnosis) {
  Section section{.id = "errors", .title = "How far the models are off"};
  Table table{.header = {"runs", "model", "error", "value"}};
  const Node errors = member_of(diagnosis, "error");
  if (const auto held = errors.find("validate")) add_errors(table, *held, "held out");
  if (const auto fitted = errors.find("fit")) add_errors(table, *fitted, "fitted");
  section.blocks.emplace_back(TableBlock{.caption = "Errors of each model", .table = std::move(table)});
  return section;
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

Section torque_section(const Node& diagnosis) {
  Section section{.id = "leftover", .title = "What is left over, as a torque"};
  const auto residual = diagnosis.find("residual");
  if (!residual || residual->is_null()) {
    section.blocks.emplace_back(Paragraph{"No residual torque was worked out from these records."});
    return section;
  }
  const Node line = member_of(*residual, "frequency_Hz");
  section.blocks.emplace_back(Paragraph{fmt::format(
      "What the model with the effects leaves over has, as a joint torque, {} N mm rms; noise alone would give {} N "
      "mm.{}",
      cell_of(*residual, "rms_Nmm"), cell_of(*residual, "smallest_visible_Nmm"),
      line.is_null() ? "" : fmt::format(" The strongest line of its spectrum lies at {} Hz.", cell_of(line)))});
  std::size_t number = 0;
  for (const Node& each : member_of(*residual, "dependences").elements()) {
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
  return section;
}

Section assumed_section(const Node& summary) {
  return {.id = "assumptions",
          .title = "What was assumed",
          .blocks = {Listing{fmt::format("{}", fmt::join(texts_of(summary, "assumptions"), "\n"))}}};
}

Section candidates_section(const Node& diagnosis) {
  Section section{.id = "candidates", .title = "Hypotheses that were compared"};
  Table table{.header = {"rank", "effects", "probability", "log evidence", "residual", "leaves noise"}};
  const auto samples = static_cast<double>(samples_of(diagnosis, "fit"));
  BarChart chart{.id = "ranking",
                 .title = "The most probable hypotheses",
                 .description = "Given that one of those that were fitted is true. The 15 most probable.",
                 .value_title = "probability",
                 .label_title = "effects"};
  std::map<std::string, int> seen;
  for (const Node& each : member_of(diagnosis, "candidates").elements()) {
    const std::string ids = ids_text(member_of(each, "effects"));
    const Node left = member_of(each, "chi_square");
    const bool is_told = !left.is_null() && samples > 0.0;
    table.rows.push_back({fmt::format("{}", table.rows.size() + 1), ids,
                          probability_text(member_of(each, "probability")), cell_of(each, "log_evidence"),
                          is_told ? short_number(std::sqrt(left.number() / samples)) : "-",
                          probability_text(member_of(each, "probability_of_noise"))});
    if (chart.bars.size() >= 15) continue;
    const int again = seen[ids]++;
    if (member_of(each, "probability").is_null()) continue;
    chart.bars.push_back({.label = again == 0 ? ids : fmt::format("{} ({})", ids, again + 1),
                          .value = member_of(each, "probability").number(),
                          .group = "compared"});
  }
  if (!chart.bars.empty()) section.blocks.emplace_back(figure_of(chart));
  if (table.rows.empty())
    section.blocks.emplace_back(Paragraph{"None were compared."});
  else
    section.blocks.emplace_back(TableBlock{.caption = "Hypotheses, most probable first", .table = std::move(table)});
  Table ruled_out{.header = {"effects", "why it has no probability"}};
  for (const Node& each : member_of(diagnosis, "ruled_out").elements())
    ruled_out.rows.push_back({ids_text(member_of(each, "effects")), member_of(each, "remark").text()});
  if (!ruled_out.rows.empty())
    section.blocks.emplace_back(TableBlock{.caption = "Not compared", .table = std::move(ruled_out)});
  section.blocks.emplace_back(
      Paragraph{"Log evidence: natural logarithm, over that of no effect. Residual: rms on the fitted runs over the "
                "noise; 1 is noise alone. Leaves noise: the probability that what a hypothesis lacks is less than a "
                "tenth of the noise."});
  return section;
}

Section warnings_section(const Node& diagnosis) {
  Section section{.id = "warnings", .title = "Warnings"};
  for (const Node& each : member_of(diagnosis, "warnings").elements()) {
    const Node run = member_of(each, "run");
    section.blocks.emplace_back(
        Paragraph{fmt::format("{}: {}", run.is_null() ? "All runs" : run.text(), member_of(each, "text").text())});
  }
  return section;
}

// What a diagnosis may say (docs/formats-diagnosis.md).
constexpr std::array<std::string_view, 6> verdicts{"no_missing_effect", "declared_numbers_off", "explained",
                                                   "partly_explained",  "unexplained",          "incomplete"};

// The words of the answer. A diagnosis by an earlier version had none, or no probabilities.
Node summary_of(const Node& diagnosis) {
  const auto summary = diagnosis.find("summary");
  const char* lacks = !summary ? "summary" : !diagnosis.find("ruled_out") ? "ruled_out" : nullptr;
  if (lacks == nullptr) return *summary;
  throw diagnosis.error_without_value(fmt::format(
      R"(must have "{}" (docs/formats.md), which an earlier version did not write: diagnose again)", lacks));
}

}  // namespace

Page diagnosis_page(const std::filesystem::path& folder, const Node& diagnosis, std::string_view made_by) {
  const std::string dataset = member_of(diagnosis, "dataset").text();
  const Node verdict = member_of(diagnosis, "verdict");
  if (std::ranges::find(verdicts, verdict.text()) == verdicts.end())
    throw verdict.error(fmt::format("must be one of {}", fmt::join(verdicts, ", ")));
  if (verdict.text() == "incomplete")
    throw verdict.error_without_value(
        "is of a diagnosis that was interrupted: summary.txt has what was known then, and there is a page once it has "
        "ended (diagnose again)");
  const Node summary = summary_of(diagnosis);
  Page page{.title = fmt::format("{}: diagnosis", dataset),
            .verdict = member_of(summary, "verdict").text(),
            .cautions = texts_of(summary, "cautions"),
            .origin = origin_text(folder, made_by),
            .inputs = input_lines(folder)};
  if (Section warnings = warnings_section(diagnosis); !warnings.blocks.empty())
    page.sections.push_back(std::move(warnings));
  page.sections.push_back(effects_section(diagnosis));
  for (Section& section : runs_sections(folder, diagnosis)) page.sections.push_back(std::move(section));
  page.sections.push_back(errors_section(diagnosis));
  page.sections.push_back(torque_section(diagnosis));
  page.sections.push_back(candidates_section(diagnosis));
  page.sections.push_back(next_section(folder, diagnosis));
  page.sections.push_back(assumed_section(summary));
  return page;
}

}  // namespace coilwright::page
