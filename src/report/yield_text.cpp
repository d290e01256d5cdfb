#include "coilwright/report/yield_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "coilwright/report/simulation/text_table.hpp"

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

std::string quantities_text(const sizing::Yield& yield) {
  TextTable table;
  table.row({"of the builds", "designed", "5 %", "50 %", "95 %", "limit", "kept by (95 % interval)"});
  for (const sizing::BuiltQuantity& each : yield.quantities)
    table.row({each.name, number_or_none(each.nominal), number_or_none(each.p05), number_or_none(each.p50),
               number_or_none(each.p95), each.keeps ? each.limit.substr(each.limit.find(' ') + 1) : "",
               kept_text(each)});
  return table.text(0, {left, right, right, right, right, right, left});
}

// By cause, most builds first.
std::string failures_text(const sizing::Yield& yield) {
  if (yield.failures.empty()) return {};
  TextTable table;
  std::size_t all = 0;
  for (const sizing::FailureCause& cause : yield.failures) {
    table.row({fmt::format("{}", cause.builds), cause.reason});
    all += cause.builds;
  }
  return fmt::format("{} of them lack a figure that is asked for, and keep nothing\n", all) +
         table.text(2, {right, left});
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
std::string shares_text(const sizing::Yield& yield, std::size_t quantity) {
  std::vector<const sizing::ScatterWorth*> order;
  for (const sizing::ScatterWorth& worth : yield.worths)
    if (const auto& total = worth.total[quantity]; total && total->value >= 0.01) order.push_back(&worth);
  if (order.empty()) return {};
  std::ranges::stable_sort(order, [quantity](const auto* one, const auto* other) {
    return one->total[quantity]->value > other->total[quantity]->value;
  });
  TextTable table;
  for (const sizing::ScatterWorth* worth : order)
    table.row({worth->scatter, index_text(worth->first[quantity]), index_text(worth->total[quantity])});
  return fmt::format("{}: share of its variance by itself, and with others (95 %)\n", yield.quantities[quantity].name) +
         table.text(2, {left, left, left});
}

std::string halves_text(const sizing::Yield& yield) {
  std::vector<const sizing::ScatterWorth*> order;
  for (const sizing::ScatterWorth& worth : yield.worths)
    if (largest_share(worth) >= 0.01) order.push_back(&worth);
  std::ranges::stable_sort(
      order, [](const auto* one, const auto* other) { return one->keeps_all.value > other->keeps_all.value; });
  TextTable table;
  for (const sizing::ScatterWorth* worth : order) table.row({worth->scatter, percent(worth->keeps_all)});
  return "If one of them scattered half as far, every limit would be kept by\n" + table.text(2, {left, left});
}

std::string shortfalls_text(const sizing::Yield& yield) {
  std::string out;
  for (const sizing::BuiltQuantity& each : yield.quantities)
    if (each.falls_short())
      out += fmt::format("MIND: {} is kept{} by {}, not by the {:.0f} % that the study asks for.\n", each.limit,
                         each.of_uses ? " " + uses_text(*each.of_uses) : "", percent(*each.keeps), 100.0 * *each.asked);
  return out;
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

std::string built_text(const sizing::Yield& yield) {
  const sizing::BuiltQuantity& objective = yield.quantities.front();
  std::string text = share_text(yield);
  if (objective.p05 && objective.p50 && objective.p95)
    text += fmt::format("  {}: 5 % of them stay below {}, half below {}, 95 % below {}\n", objective.name,
                        short_number(*objective.p05), short_number(*objective.p50), short_number(*objective.p95));
  return text;
}

std::string shortfalls_of_answer_text(const sizing::Yield& yield) {
  const std::string shortfalls = shortfalls_text(yield);
  if (shortfalls.empty()) return {};
  return shortfalls +
         "The search judged every design by too few builds for this: more of them (\"draws\" of the study's spread) "
         "are "
         "the cure.\n";
}

std::string to_text(const sizing::Yield& yield) {
  std::string out = share_text(yield);
  out += failures_text(yield);
  out += "\n" + quantities_text(yield) + shortfalls_text(yield);
  if (yield.worths.empty()) return out;
  std::set<std::string> shown;  // a quantity may have two limits, or be an objective with one
  for (std::size_t i = 0; i < yield.quantities.size(); ++i)
    if (!shown.insert(yield.quantities[i].name).second)
      continue;
    else if (const std::string shares = shares_text(yield, i); !shares.empty())
      out += "\n" + shares;
  return out + "\n" + halves_text(yield);
}

}  // namespace coilwright::report
