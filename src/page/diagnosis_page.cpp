#include "page/diagnosis_page.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "coilwright/page/chart.hpp"
#include "page/next_section.hpp"
#include "page/result_words.hpp"
#include "page/run_figures.hpp"
#include "page/summary_text.hpp"

namespace coilwright::page {
namespace {

using text::Node;

// The paragraph below the title of summary.txt: the verdict as the program words it.
std::string verdict_of(const std::filesystem::path& folder) {
  return summary_lines(folder, "").front();
}

// The lines below it: numbers that moved far, errors that rose, a zero to check.
std::vector<std::string> cautions_of(const std::filesystem::path& folder) {
  std::vector<std::string> lines = summary_lines(folder, "");
  lines.erase(lines.begin());
  return lines;
}

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
  if (!idle_from) return cell_of(number.find("value").value());
  const bool below = idle_from->number() < number.find("declared").value().number();
  return fmt::format("{} {}", below ? "below" : "above", cell_of(*idle_from));
}

Section effects_section(const Node& diagnosis) {
  Section section{.id = "effects", .title = "What the model lacks", .blocks = {}};
  Table table{
      .header = {"effect", "number", "value", "95 % interval", "gain of the criterion", "gain on runs left out"},
      .rows = {}};
  for (const Node& effect : diagnosis.find("effects").value().elements()) {
    const auto evidence = effect.find("evidence");
    const auto gain = [&](const char* key) {
      return evidence && !evidence->is_null() && evidence->find(key) ? cell_of(evidence->find(key).value()) : "-";
    };
    bool first = true;
    const std::vector<Node> parameters = effect.find("parameters").value().members();
    if (parameters.empty())
      table.rows.push_back(
          {effect.find("id").value().text(), "", "", "", gain("criterion_gain"), gain("cross_validated_gain")});
    for (const Node& parameter : parameters) {
      table.rows.push_back({first ? effect.find("id").value().text() : "", parameter.key(),
                            cell_of(parameter.find("value").value()), interval_text(parameter),
                            first ? gain("criterion_gain") : "", first ? gain("cross_validated_gain") : ""});
      first = false;
    }
  }
  if (table.rows.empty())
    section.blocks.emplace_back(Paragraph{"No effect was added to the model."});
  else
    section.blocks.emplace_back(TableBlock{.caption = "Effects, and their numbers", .table = std::move(table)});
  Table moved{.header = {"number", "declared", "now", "95 % interval"}, .rows = {}};
  for (const char* key : {"calibration", "nominal"})
    if (const auto numbers = diagnosis.find(key))
      for (const Node& each : numbers->members())
        moved.rows.push_back({each.key(), each.find("declared") ? cell_of(each.find("declared").value()) : "-",
                              fitted_text(each), interval_text(each)});
  if (!moved.rows.empty())
    section.blocks.emplace_back(
        TableBlock{.caption = "Declared numbers as the fit has them", .table = std::move(moved)});
  return section;
}

// Numbers of one object of errors, without those of other quantities inside of it.
void add_errors(Table& table, const Node& errors, const std::string& runs) {
  for (const auto& [key, name] :
       {std::pair{"declared", "as declared"}, std::pair{"before", "recalibrated"},
        std::pair{"after", "with the effects"}, std::pair{"corrected", "with a nameless torque"}}) {
    const auto model = errors.find(key);
    if (!model || model->is_null()) continue;
    for (const Node& each : model->members())
      if (each.kind() == Node::Kind::number) table.rows.push_back({runs, name, each.key(), cell_of(each)});
  }
  for (const Node& each : errors.members())
    if (each.kind() == Node::Kind::number && each.key() != "samples")
      table.rows.push_back({runs, "", each.key(), cell_of(each)});
}

Section errors_section(const Node& diagnosis) {
  Section section{.id = "errors", .title = "How far the models are off", .blocks = {}};
  Table table{.header = {"runs", "model", "error", "value"}, .rows = {}};
  const Node errors = diagnosis.find("error").value();
  if (const auto held = errors.find("validate")) add_errors(table, *held, "held out");
  if (const auto fitted = errors.find("fit")) add_errors(table, *fitted, "fitted");
  section.blocks.emplace_back(TableBlock{.caption = "Errors of each model", .table = std::move(table)});
  return section;
}

std::vector<Section> runs_sections(const std::filesystem::path& folder) {
  Section held{.id = "held", .title = "Runs that no fit has seen", .blocks = {}};
  Section fitted{.id = "fitted", .title = "Runs that were fitted", .blocks = {}};
  std::size_t number = 0;
  for (const RunRecord& record : read_runs(folder)) {
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
  Section section{.id = "leftover", .title = "What is left over, as a torque", .blocks = {}};
  const auto residual = diagnosis.find("residual");
  if (!residual || residual->is_null()) {
    section.blocks.emplace_back(Paragraph{"No residual torque was worked out from these records."});
    return section;
  }
  const Node line = residual->find("frequency_Hz").value();
  section.blocks.emplace_back(Paragraph{fmt::format(
      "What the model with the effects leaves over has, as a joint torque, {} N mm rms; noise alone would give {} N "
      "mm.{}",
      cell_of(residual->find("rms_Nmm").value()), cell_of(residual->find("smallest_visible_Nmm").value()),
      line.is_null() ? "" : fmt::format(" The strongest line of its spectrum lies at {} Hz.", cell_of(line)))});
  std::size_t number = 0;
  for (const Node& each : residual->find("dependences").value().elements()) {
    const std::string variable = each.find("variable").value().text();
    Series series{
        .name = "residual torque", .x = {}, .y = each.find("residual_Nmm").value().numbers(), .mark = Mark::points};
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
                                         variable, 100.0 * each.find("explained").value().number()),
              .x_title = title,
              .y_title = "residual torque, N mm",
              .series = {std::move(joined), std::move(series)}}));
  }
  return section;
}

Section candidates_section(const Node& diagnosis) {
  Section section{.id = "candidates", .title = "Hypotheses that were compared", .blocks = {}};
  Table table{.header = {"rank", "effects", "gain of the criterion", "gain on runs left out",
                         "squared error over noise after", "remark"},
              .rows = {}};
  BarChart chart{
      .id = "ranking",
      .title = "The hypotheses by their gain",
      .description = "Gain of the criterion over the recalibrated model, with its charge for parameters; the 15 best.",
      .value_title = "gain of the criterion",
      .label_title = "effects",
      .bars = {}};
  std::map<std::string, int> seen;
  for (const Node& each : diagnosis.find("candidates").value().elements()) {
    const std::string ids = ids_text(each.find("effects").value());
    const auto evidence = each.find("evidence");
    const bool known = evidence && !evidence->is_null();
    const auto number = [&](const char* key) { return known ? cell_of(evidence->find(key).value()) : "-"; };
    table.rows.push_back({fmt::format("{}", table.rows.size() + 1), ids, number("criterion_gain"),
                          number("cross_validated_gain"), number("chi_square_after"),
                          cell_of(each.find("remark").value())});
    if (!known || chart.bars.size() >= 15) continue;
    const int again = seen[ids]++;
    const double gain = evidence->find("criterion_gain").value().number();
    chart.bars.push_back({.label = again == 0 ? ids : fmt::format("{} ({})", ids, again + 1),
                          .value = gain,
                          .group = each.find("remark").value().is_null() ? "compared" : "set aside"});
  }
  if (!chart.bars.empty()) section.blocks.emplace_back(figure_of(chart));
  if (table.rows.empty())
    section.blocks.emplace_back(Paragraph{"None were compared."});
  else
    section.blocks.emplace_back(TableBlock{.caption = "Hypotheses, best first", .table = std::move(table)});
  return section;
}

Section warnings_section(const Node& diagnosis) {
  Section section{.id = "warnings", .title = "Warnings", .blocks = {}};
  for (const Node& each : diagnosis.find("warnings").value().elements()) {
    const Node run = each.find("run").value();
    section.blocks.emplace_back(
        Paragraph{fmt::format("{}: {}", run.is_null() ? "All runs" : run.text(), each.find("text").value().text())});
  }
  return section;
}

}  // namespace

Page diagnosis_page(const std::filesystem::path& folder, const Node& diagnosis, std::string_view made_by) {
  const std::string dataset = diagnosis.find("dataset").value().text();
  require_summary_of(folder, dataset, diagnosis.find("verdict").value().text());
  Page page{.title = fmt::format("{}: diagnosis", dataset),
            .verdict = verdict_of(folder),
            .cautions = cautions_of(folder),
            .origin = origin_text(folder, made_by),
            .sections = {}};
  Section warnings = warnings_section(diagnosis);
  page.sections.push_back(effects_section(diagnosis));
  page.sections.push_back(errors_section(diagnosis));
  for (Section& section : runs_sections(folder)) page.sections.push_back(std::move(section));
  page.sections.push_back(torque_section(diagnosis));
  page.sections.push_back(candidates_section(diagnosis));
  page.sections.push_back(next_section(folder, diagnosis));
  if (!warnings.blocks.empty()) page.sections.push_back(std::move(warnings));
  return page;
}

}  // namespace coilwright::page
