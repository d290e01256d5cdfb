#include "formats/study/wanted_quantities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "coilwright/sizing/study/expression.hpp"
#include "coilwright/text/spelling.hpp"
#include "formats/study/crawler_block.hpp"
#include "formats/study/gripper_block.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using namespace sizing;
using simulation::QuantityTable;
using simulation::ResultQuantity;

constexpr Rule limit_rule = Rule::between(-1e12, 1e12);

std::string nearest_quantity(std::string_view name, const QuantityTable& quantities) {
  std::vector<std::string> names;
  for (const ResultQuantity& quantity : quantities) names.push_back(quantity.name);
  const std::string meant = did_you_mean(name, names);
  return meant.empty() ? "; coilwright list quantities has them all" : meant;
}

// A name that a block would bring which the study does not have.
void refuse_without_block(const Node& node, const std::string& name) {
  for (const auto& [block, names] :
       {std::pair{"gripper", gripper_quantity_names()}, std::pair{"crawler", crawler_quantity_names()}})
    if (std::ranges::count(names, name) > 0)
      throw node.error(fmt::format("needs the block \"{}\" in the study", block));
}

ResultQuantity read_expression(const Node& node, ObjectReader& in, const QuantityTable& quantities) {
  const std::string& text = node.text();
  Expression expression{.text = text, .name = {}, .unit = {}};
  try {
    // First the expression alone: that its name is missing says nothing to a person who misspelt a quantity.
    (void)expression_quantity({.text = text, .name = "any", .unit = "1"}, quantities);
    expression.name = in.text("name");
    expression.unit = in.text("unit");
    expression.scale = in.number_or("scale", 0.0, positive);
    ResultQuantity quantity = expression_quantity(expression, quantities);
    const ResultQuantity* same = quantities.find(quantity.name);
    if (same != nullptr && same->meaning != quantity.meaning)
      throw in.at("name").error(fmt::format("makes a name that is taken (\"{}\")", quantity.name));
    return quantity;
  } catch (const UnknownSymbol& unknown) {
    refuse_without_block(node, unknown.symbol());
    throw node.error(unknown.what() + nearest_quantity(unknown.symbol(), quantities));
  } catch (const std::invalid_argument& mistake) {
    throw node.error(mistake.what());
  }
}

void add_once(QuantityTable& table, const ResultQuantity& quantity) {
  if (table.find(quantity.name) == nullptr) table = table.with(quantity);
}

// A quantity by its name, or an expression of quantities, which comes with a name and a unit of its own. Results list
// it.
ResultQuantity read_quantity(const Node& node, ObjectReader& in, StudyQuantities& quantities) {
  const std::string& text = node.text();
  if (const ResultQuantity* found = quantities.known.find(text)) {
    ResultQuantity quantity = *found;
    add_once(quantities.listed, quantity);
    return quantity;
  }
  if (is_name(text)) {
    refuse_without_block(node, text);
    throw node.error("must be a quantity that evaluate prints" + nearest_quantity(text, quantities.known));
  }
  ResultQuantity quantity = read_expression(node, in, quantities.known);
  add_once(quantities.known, quantity);
  add_once(quantities.listed, quantity);
  return quantity;
}

StudyObjective read_objective(const Node& node, StudyQuantities& quantities) {
  return read_object(node, [&quantities](ObjectReader& in) {
    // British as everything is written, and American as many people type it.
    const std::string sense = in.one_of({"maximise", "minimise", "maximize", "minimize"});
    return StudyObjective{.quantity = read_quantity(in.at(sense), in, quantities),
                          .sense = sense.starts_with("max") ? Sense::maximise : Sense::minimise};
  });
}

Limit read_limit(const Node& node, StudyQuantities& quantities) {
  return read_object(node, [&quantities](ObjectReader& in) {
    Limit limit{.quantity = read_quantity(in.at("quantity"), in, quantities)};
    const std::string side = in.one_of({"at_most", "at_least"});
    limit.side = side == "at_most" ? Limit::Side::at_most : Limit::Side::at_least;
    limit.value = in.number(side, limit_rule);
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
