#include "coilwright/report/systems/comparison_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace coilwright::report {
namespace {

using systems::validation::Comparison;
using enum TextTable::Align;

double difference_percent(double ratio) {
  return 100.0 * (ratio - 1.0);
}

}  // namespace

Document document_of(std::span<const Comparison> rows) {
  BarChart chart{.id = "differences",
                 .title = "Model less reference, and the band of each difference",
                 .description =
                     "For each figure of the paper the difference of the model in per cent of the reference, between "
                     "the two ends of the band in which it must lie.",
                 .value_title = "difference, % of the reference",
                 .label_title = "figure",
                 .symbols = true};
  TableBlock block{.caption = "Every figure",
                   .table = {.header = {"quantity", "reference", "model", "diff %", "band %", "", "reference from",
                                        "where the difference comes from"}},
                   .align = {left, right, right, right, right, left, left, left}};
  for (const Comparison& row : rows) {
    for (const double end : {row.band_low, row.band_high})
      chart.bars.push_back({.label = row.quantity, .value = difference_percent(end), .group = "end of its band"});
    chart.bars.push_back({.label = row.quantity,
                          .value = difference_percent(row.ratio()),
                          .group = row.holds() ? "difference, in its band" : "difference, outside of its band"});
    block.table.rows.push_back(
        {row.quantity, short_number(row.reference), short_number(row.model),
         fmt::format("{:+.2f}", difference_percent(row.ratio())),
         fmt::format("{:+.2f} .. {:+.2f}", difference_percent(row.band_low), difference_percent(row.band_high)),
         row.holds() ? "" : "!!", row.source, row.because});
  }
  const auto farthest = std::ranges::max_element(
      rows, {}, [](const Comparison& row) { return std::max(row.ratio(), 1.0 / row.ratio()); });
  return {.title = "The model beside the figures of the paper",
          .verdict = fmt::format("{} of {} within their bands. The largest difference is {:+.1f} %, of {}: {}.",
                                 std::ranges::count_if(rows, &Comparison::holds), rows.size(),
                                 difference_percent(farthest->ratio()), farthest->quantity, farthest->because),
          .sections = {{.id = "comparison",
                        .title = "Each figure, with the band of its difference",
                        .blocks = {std::move(chart), std::move(block)}}}};
}

}  // namespace coilwright::report
