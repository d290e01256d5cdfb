#include "coilwright/report/yield_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "coilwright/text/number.hpp"

namespace coilwright::report {
namespace {

using enum TextTable::Align;

std::string number_or_none(const std::optional<double>& value) {
  return value ? short_number(*value) : "none";
}

std::string percent(const sizing::Share& share) {
  return fmt::format("{:.4g} % ({:.4g} to {:.4g})", 100.0 * share.value, 100.0 * share.low, 100.0 * share.high);
}

std::string kept_text(const sizing::BuiltQuantity& quantity) {
  std::string out = quantity.keeps ? percent(*quantity.keeps) : "";
  if (quantity.of_uses) out += (out.empty() ? "" : " ") + uses_text(*quantity.of_uses);
  return out;
}

TableBlock quantities_table(const sizing::Yield& yield) {
  TableBlock out{
      .caption = "What the builds are",
      .table = {.header = {"of the builds", "designed", "5 %", "50 %", "95 %", "limit", "kept by (95 % interval)"}},
      .align = {left, right, right, right, right, right, left}};
  for (const sizing::BuiltQuantity& each : yield.quantities)
    out.table.rows.push_back({each.name, number_or_none(each.nominal), number_or_none(each.p05),
                              number_or_none(each.p50), number_or_none(each.p95),
                              each.keeps ? each.limit.substr(each.limit.find(' ') + 1) : "", kept_text(each)});
  return out;
}

BarChart margins_chart(const sizing::Yield& yield) {
  BarChart chart{
      .id = "built_margins",
      .title = "Margins of the builds",
      .description =
          "How far each limit is from being reached, in per cent of the limit: of the design, of the middle "
          "build, and at both ends of what nine builds in ten lie between. To the left of 0 a limit is broken.",
      .value_title = "margin, %",
      .label_title = "limit",
      .symbols = true};
  for (const sizing::BuiltQuantity& each : yield.quantities) {
    const auto limit = text::number_in(each.limit.substr(each.limit.rfind(' ') + 1));
    if (!limit || *limit == 0.0) continue;
    const double sign = each.limit.find(">=") == std::string::npos ? 1.0 : -1.0;
    for (const auto& [value, group] :
         {std::pair(each.p05, "5 % of builds are below"), std::pair(each.p50, "middle build"),
          std::pair(each.p95, "95 % of builds are below"), std::pair(each.nominal, "designed")})
      if (value)
        chart.bars.push_back(
            {.label = each.limit, .value = 100.0 * sign * (*limit - *value) / std::abs(*limit), .group = group});
  }
  return chart;
}

// By cause, most builds first.
void add_failures(Section& section, const sizing::Yield& yield) {
  if (yield.failures.empty()) return;
  TableBlock block{.caption = "Builds without a figure",
                   .table = {.header = {"builds", "reason"}},
                   .align = {right, left},
                   .headed = false};
  std::size_t all = 0;
  for (const sizing::FailureCause& cause : yield.failures) {
    block.table.rows.push_back({fmt::format("{}", cause.builds), cause.reason});
    all += cause.builds;
  }
  section.blocks.emplace_back(
      Lines{fmt::format("{} of them lack a figure that is asked for, and keep nothing\n", all)});
  section.blocks.emplace_back(std::move(block));
}

std::string index_text(const std::optional<sizing::SobolIndex>& index) {
  return index ? fmt::format("{:.2f} ({:.2f} to {:.2f})", index->value, index->low, index->high) : "-";
}

// The share that a scatter has in any quantity, by which it is worth its line.
double largest_share(const sizing::ScatterWorth& worth) {
  double out = 0.0;
  for (const auto& total : worth.total)
    if (total) out = std::max(out, total->value);
  return out;
}

// Of the variance of one quantity, largest first; scatters of less than a hundredth are left out.
Section shares_section(const sizing::Yield& yield, std::size_t quantity) {
  std::vector<const sizing::ScatterWorth*> order;
  for (const sizing::ScatterWorth& worth : yield.worths)
    if (const auto& total = worth.total[quantity]; total && total->value >= 0.01) order.push_back(&worth);
  std::ranges::stable_sort(order, [quantity](const auto* one, const auto* other) {
    return one->total[quantity]->value > other->total[quantity]->value;
  });
  const std::string& name = yield.quantities[quantity].name;
  BarChart chart{.id = fmt::format("scatter-{}", quantity + 1),
                 .title = fmt::format("Which scatter decides: {}", name),
                 .description = "Share of each scatter in the variance of the builds, with all others.",
                 .value_title = "share of the variance",
                 .label_title = "scatter"};
  TableBlock block{.caption = fmt::format("Which scatter decides: {}", name),
                   .table = {.header = {"scatter", "by itself (95 %)", "with others (95 %)"}},
                   .align = {left, left, left},
                   .headed = false};
  for (const sizing::ScatterWorth* worth : order) {
    block.table.rows.push_back(
        {worth->scatter, index_text(worth->first[quantity]), index_text(worth->total[quantity])});
    chart.bars.push_back({.label = worth->scatter, .value = worth->total[quantity]->value, .group = "with others"});
  }
  Section section{.id = fmt::format("worth-{}", quantity + 1),
                  .title = fmt::format("{}: share of its variance by itself, and with others (95 %)", name)};
  if (!order.empty()) section.blocks = {std::move(chart), std::move(block)};
  return section;
}

Section halves_section(const sizing::Yield& yield) {
  std::vector<const sizing::ScatterWorth*> order;
  for (const sizing::ScatterWorth& worth : yield.worths)
    if (largest_share(worth) >= 0.01) order.push_back(&worth);
  std::ranges::stable_sort(
      order, [](const auto* one, const auto* other) { return one->keeps_all.value > other->keeps_all.value; });
  TableBlock block{.caption = "Half of a scatter",
                   .table = {.header = {"scatter", "kept by (95 % interval)"}},
                   .align = {left, left},
                   .headed = false};
  for (const sizing::ScatterWorth* worth : order)
    block.table.rows.push_back({worth->scatter, percent(worth->keeps_all)});
  return {.id = "halves",
          .title = "If one of them scattered half as far, every limit would be kept by",
          .blocks = {std::move(block)}};
}

std::string share_text(const sizing::Yield& yield) {
  std::vector<std::string> names;
  double share = 1.0;
  for (const sizing::BuiltQuantity& each : yield.quantities) {
    if (!each.of_uses) continue;
    share = *each.of_uses;
    names.push_back(each.name);
  }
  std::string out =
      fmt::format("{} of {} builds by fresh dice keep every limit\n", percent(yield.keeps_all), yield.builds);
  if (!names.empty())
    out += fmt::format("  {}, its worst: {}; all else in one use of each build, by dice\n", uses_text(share),
                       fmt::join(names, ", "));
  return out;
}

}  // namespace

std::string uses_text(double share) {
  return share < 1.0 ? fmt::format("in {:.4g} % of uses", 100.0 * share) : "in every use";
}

std::vector<std::string> shortfalls_of(const sizing::Yield& yield) {
  std::vector<std::string> out;
  for (const sizing::BuiltQuantity& each : yield.quantities)
    if (each.falls_short())
      out.push_back(fmt::format("MIND: {} is kept{} by {}, not by the {:.0f} % that the study asks for.\n", each.limit,
                                each.of_uses ? " " + uses_text(*each.of_uses) : "", percent(*each.keeps),
                                100.0 * *each.asked));
  return out;
}

std::vector<Section> builds_sections(const sizing::Yield& yield) {
  Section builds{.id = "builds", .title = "What builds make of it", .blocks = {Lines{share_text(yield)}}};
  add_failures(builds, yield);
  builds.blocks.emplace_back(margins_chart(yield));
  builds.blocks.emplace_back(quantities_table(yield));
  std::vector<Section> out{std::move(builds)};
  if (yield.worths.empty()) return out;
  std::set<std::string> shown;  // a quantity may have two limits, or be an objective with one
  for (std::size_t i = 0; i < yield.quantities.size(); ++i)
    if (shown.insert(yield.quantities[i].name).second) out.push_back(shares_section(yield, i));
  out.push_back(halves_section(yield));
  return out;
}

Document document_of(const sizing::Yield& yield) {
  return {.cautions = shortfalls_of(yield), .sections = builds_sections(yield)};
}

}  // namespace coilwright::report
