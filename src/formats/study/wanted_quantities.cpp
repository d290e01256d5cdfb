#include "formats/study/study_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "coilwright/actuator/design/parameters.hpp"
#include "coilwright/sizing/study/expression.hpp"
#include "coilwright/text/spelling.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using namespace sizing;
using simulation::QuantityTable;
using simulation::ResultQuantity;

constexpr Rule limit_rule = Rule::between(-1e12, 1e12);

// "p5_mass_g" for "p05_mass_g".
std::optional<std::string> with_two_digits(std::string_view name, const QuantityTable& quantities) {
  if (name.size() < 3 || name[0] != 'p' || name[1] < '1' || name[1] > '9' || name[2] != '_') return std::nullopt;
  const std::string meant = "p0" + std::string(name.substr(1));
  return quantities.find(statistic_named(meant)->quantity) == nullptr ? std::nullopt : std::optional(meant);
}

std::string nearest_quantity(std::string_view name, const QuantityTable& quantities) {
  if (const auto percentile = with_two_digits(name, quantities))
    return fmt::format("; did you mean \"{}\"? A percentile has two digits", *percentile);
  std::vector<std::string> names;
  for (const ResultQuantity& quantity : quantities) names.push_back(quantity.name);
  const std::string meant = did_you_mean(name, names);
  return meant.empty() ? "; coilwright list quantities has them all" : meant;
}

// A name that a block would bring which the study does not have.
void refuse_without_block(const Node& node, const std::string& name) {
  if (const auto block = block_of_quantity(name))
    throw node.error(fmt::format("needs the block \"{}\" in the study", *block));
}

// The first name in an expression that is no quantity; nothing where there is none, or where it cannot be read.
std::optional<std::string> unknown_symbol(const std::string& text, const QuantityTable& quantities) {
  try {
    (void)expression_quantity({.text = text, .name = "any", .unit = "1"}, quantities);
  } catch (const UnknownSymbol& unknown) {
    return unknown.symbol();
  } catch (const std::invalid_argument&) {
    // said where it is read
  }
  return std::nullopt;
}

// A name that asks for a statistic of the spread becomes known; whether it was one.
bool make_known(StudyQuantities& quantities, const std::string& name) {
  if (quantities.known.find(name) != nullptr) return true;
  if (!quantities.spread) return false;
  const std::optional<ResultQuantity> statistic = quantities.spread->find(name, quantities.known);
  if (statistic) quantities.known = quantities.known.with(*statistic);
  return statistic.has_value();
}

void refuse_without_spread(const Node& node, const StudyQuantities& quantities, const std::string& name) {
  const std::optional<StatisticName> parts = statistic_named(name);
  if (parts && !quantities.spread && quantity_of(*parts, quantities.known))
    throw node.error("is a statistic of builds: needs the block \"spread\" in the study");
}

// The table in which each statistic is what it is of, under its name; nothing where it has none.
std::optional<QuantityTable> table_of_builds(const QuantityTable& known) {
  std::vector<ResultQuantity> out;
  bool any = false;
  for (const ResultQuantity& each : known) {
    const std::optional<StatisticName> parts = statistic_named(each.name);
    const std::optional<ResultQuantity> of = parts ? quantity_of(*parts, known) : std::nullopt;
    out.push_back(of.value_or(each));
    out.back().name = each.name;
    any = any || of;
  }
  return any ? std::optional(QuantityTable(std::move(out))) : std::nullopt;
}

// A column of a table of designs beside quantities, or the name of a variable: an expression of that name would be one
// column with it.
bool is_taken(std::string_view name) {
  constexpr std::array ours = {"evaluation", "status", "reason", "best_for", "row",
                               "number",     "run",    "took_s", "current_A"};
  return std::ranges::find(ours, name) != ours.end() || name.find("_max_margin") != std::string_view::npos ||
         name.find("_min_margin") != std::string_view::npos || actuator::find_parameter(name) != nullptr;
}

ResultQuantity read_expression(const Node& node, ObjectReader& in, StudyQuantities& all) {
  const std::string& text = node.text();
  while (const std::optional<std::string> unknown = unknown_symbol(text, all.known))
    if (!make_known(all, *unknown)) break;
  const QuantityTable& quantities = all.known;
  Expression expression{.text = text, .name = {}, .unit = {}};
  try {
    // First the expression alone: that its name is missing says nothing to a person who misspelt a quantity.
    (void)expression_quantity({.text = text, .name = "any", .unit = "1"}, quantities);
  } catch (const UnknownSymbol& unknown) {
    refuse_without_block(node, unknown.symbol());
    refuse_without_spread(node, all, unknown.symbol());
    throw node.error(unknown.what() + nearest_quantity(unknown.symbol(), quantities));
  } catch (const std::invalid_argument& mistake) {
    throw node.error(mistake.what());
  }
  expression.name = in.text("name");
  expression.unit = in.text("unit");
  expression.scale = in.number_or("scale", 0.0, positive);
  ResultQuantity quantity = expression_quantity(expression, quantities);
  const ResultQuantity* same = quantities.find(quantity.name);
  if ((same != nullptr && same->meaning != quantity.meaning) || is_taken(quantity.name))
    throw in.at("name").error(fmt::format("makes a name that is taken (\"{}\")", quantity.name));
  if (const auto builds = all.spread ? table_of_builds(quantities) : std::nullopt)
    all.of_builds.insert_or_assign(quantity.name, expression_quantity(expression, *builds));
  return quantity;
}

void add_once(QuantityTable& table, const ResultQuantity& quantity) {
  if (table.find(quantity.name) == nullptr) table = table.with(quantity);
}

// A quantity by its name, or an expression of quantities, which comes with a name and a unit of its own. Results list
// it.
ResultQuantity read_quantity(const Node& node, ObjectReader& in, StudyQuantities& quantities) {
  const std::string& text = node.text();
  (void)make_known(quantities, text);
  if (const ResultQuantity* found = quantities.known.find(text)) {
    ResultQuantity quantity = *found;
    add_once(quantities.listed, quantity);
    return quantity;
  }
  if (is_name(text)) {
    refuse_without_block(node, text);
    refuse_without_spread(node, quantities, text);
    throw node.error("must be a quantity that evaluate prints" + nearest_quantity(text, quantities.known));
  }
  ResultQuantity quantity = read_expression(node, in, quantities);
  add_once(quantities.known, quantity);
  add_once(quantities.listed, quantity);
  return quantity;
}

// What a statistic of builds, or an expression of some, is in one build; nothing for another quantity.
std::optional<ResultQuantity> of_build(const ResultQuantity& quantity, const StudyQuantities& quantities) {
  if (const auto found = quantities.of_builds.find(quantity.name); found != quantities.of_builds.end())
    return found->second;
  const std::optional<StatisticName> parts = statistic_named(quantity.name);
  return quantities.spread && parts ? quantity_of(*parts, quantities.known) : std::nullopt;
}

StudyObjective read_objective(const Node& node, StudyQuantities& quantities) {
  return read_object(node, [&quantities](ObjectReader& in) {
    // British as everything is written, and American as many people type it.
    const std::string sense = in.one_of({"maximise", "minimise", "maximize", "minimize"});
    StudyObjective objective{.quantity = read_quantity(in.at(sense), in, quantities),
                             .sense = sense.starts_with("max") ? Sense::maximise : Sense::minimise};
    objective.of_build = of_build(objective.quantity, quantities);
    return objective;
  });
}

Limit read_limit(const Node& node, StudyQuantities& quantities) {
  return read_object(node, [&quantities](ObjectReader& in) {
    Limit limit{.quantity = read_quantity(in.at("quantity"), in, quantities)};
    const std::string side = in.one_of({"at_most", "at_least"});
    limit.side = side == "at_most" ? Limit::Side::at_most : Limit::Side::at_least;
    limit.value = in.number(side, limit_rule);
    limit.of_build = of_build(limit.quantity, quantities);
    return limit;
  });
}

}  // namespace

std::vector<StudyObjective> read_objectives(const Node& node, StudyQuantities& quantities) {
  std::vector<StudyObjective> objectives;
  for (const Node& element : node.elements(Length::from_to(1, 3))) {
    objectives.push_back(read_objective(element, quantities));
    const auto same = [&](const StudyObjective& other) {
      return other.quantity.name == objectives.back().quantity.name;
    };
    if (std::ranges::count_if(objectives, same) > 1) throw element.error_without_value("asks for a quantity twice");
  }
  return objectives;
}

std::vector<Limit> read_limits(const Node& node, StudyQuantities& quantities) {
  std::vector<Limit> limits;
  for (const Node& element : node.elements(Length::from_to(0, 4 * quantities.known.size()))) {
    const Limit limit = read_limit(element, quantities);
    for (const Limit& other : limits) {
      if (other.quantity.name != limit.quantity.name) continue;
      if (other.side == limit.side) throw element.error_without_value("limits the same side of a quantity twice");
      const double low = limit.side == Limit::Side::at_least ? limit.value : other.value;
      const double high = limit.side == Limit::Side::at_least ? other.value : limit.value;
      if (low > high)
        throw element.error_without_value(
            fmt::format("contradicts an earlier limit: {} cannot be >= {} and <= {}", limit.quantity.name, low, high));
    }
    limits.push_back(limit);
  }
  return limits;
}

void read_columns(const Node& node, StudyQuantities& quantities) {
  for (const Node& element : node.elements(Length::from_to(0, quantities.known.size())))
    read_object(element, [&quantities](ObjectReader& in) { return read_quantity(in.at("quantity"), in, quantities); });
}

}  // namespace coilwright::formats
