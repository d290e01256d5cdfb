#include "coilwright/page/pages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "coilwright/page/chart.hpp"

namespace coilwright::page {
namespace {

using systems::validation::Comparison;

double percent(double ratio) {
  return 100.0 * (ratio - 1.0);
}

std::string verdict_of(std::span<const Comparison> rows) {
  std::vector<std::string> outside;
  for (const Comparison& row : rows)
    if (!row.holds()) outside.push_back(row.quantity);
  const auto farthest = std::ranges::max_element(
      rows, {}, [](const Comparison& row) { return std::max(row.ratio(), 1.0 / row.ratio()); });
  return fmt::format(
      "{} of {} differences between the model and the paper lie within the bands that are stated for them. The largest "
      "one is {:+.1f} %, of {}: {}.",
      rows.size() - outside.size(), rows.size(), percent(farthest->ratio()), farthest->quantity, farthest->because);
}

Figure differences_figure(std::span<const Comparison> rows) {
  BarChart chart{.id = "differences",
                 .title = "Model less reference, and the band of each difference",
                 .description =
                     "For each figure of the paper the difference of the model in per cent of the reference, between "
                     "the two ends of the band in which it must lie.",
                 .value_title = "difference, % of the reference",
                 .label_title = "figure",
                 .symbols = true};
  for (const Comparison& row : rows) {
    chart.bars.push_back({.label = row.quantity, .value = percent(row.band_low), .group = "end of its band"});
    chart.bars.push_back({.label = row.quantity, .value = percent(row.band_high), .group = "end of its band"});
    chart.bars.push_back({.label = row.quantity,
                          .value = percent(row.ratio()),
                          .group = row.holds() ? "difference, in its band" : "difference, outside of its band"});
  }
  return figure_of(chart);
}

TableBlock rows_table(std::span<const Comparison> rows) {
  Table table{.header = {"figure", "reference", "model", "difference, %", "band, %", "holds", "reference from",
                         "where the difference comes from"}};
  for (const Comparison& row : rows)
    table.rows.push_back({row.quantity, short_number(row.reference), short_number(row.model),
                          fmt::format("{:+.2f}", percent(row.ratio())),
                          fmt::format("{:+.2f} to {:+.2f}", percent(row.band_low), percent(row.band_high)),
                          row.holds() ? "yes" : "no", row.source, row.because});
  return {.caption = "Every figure", .table = std::move(table)};
}

}  // namespace

Page comparison_page(std::span<const Comparison> rows, std::string_view made_by) {
  Section section{.id = "comparison", .title = "The model beside the paper"};
  section.blocks.emplace_back(differences_figure(rows));
  section.blocks.emplace_back(rows_table(rows));
  return {.title = "The model beside the figures of the paper",
          .verdict = verdict_of(rows),
          .origin = fmt::format("Page by {}.", made_by),
          .sections = {std::move(section)}};
}

}  // namespace coilwright::page
