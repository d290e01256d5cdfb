#include "coilwright/formats/study/study_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "coilwright/formats/actuator/actuator_file.hpp"
#include "coilwright/sizing/study/expression.hpp"
#include "coilwright/text/json/document.hpp"
#include "coilwright/text/json/object_reader.hpp"
#include "coilwright/text/spelling.hpp"
#include "formats/actuator/design_reader.hpp"
#include "formats/actuator/operating_point_reader.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using namespace sizing;

// Bounds far beyond any hardware and any search, and near enough that nothing overflows.
constexpr std::size_t most_values = 1'000'000;  // of one variable
constexpr Rule largest_share = positive.and_also(Rule::at_most(1e3));
constexpr Rule limit_rule = Rule::between(-1e12, 1e12);

using simulation::QuantityTable;
using simulation::ResultQuantity;

std::string nearest_quantity(std::string_view name, const QuantityTable& quantities) {
  std::vector<std::string> names;
  for (const ResultQuantity& quantity : quantities) names.push_back(quantity.name);
  return did_you_mean(name, names);
}

ResultQuantity read_expression(const Node& node, ObjectReader& in, const QuantityTable& quantities) {
  const std::string text = node.text();
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
    throw node.error(unknown.what() + nearest_quantity(unknown.symbol(), quantities));
  } catch (const std::invalid_argument& mistake) {
    throw node.error(mistake.what());
  }
}

// A quantity by its name, or an expression of quantities, which comes with a name and a unit of its own and joins the
// table.
ResultQuantity read_quantity(const Node& node, ObjectReader& in, QuantityTable& quantities) {
  const std::string text = node.text();
  if (const ResultQuantity* quantity = quantities.find(text)) return *quantity;
  if (is_name(text)) throw node.error("must be a quantity that evaluate prints" + nearest_quantity(text, quantities));
  ResultQuantity quantity = read_expression(node, in, quantities);
  if (quantities.find(quantity.name) == nullptr) quantities = quantities.with(quantity);
  return quantity;
}

double read_value(const Node& node, const Rule& rule, VariableKind kind) {
  return kind == VariableKind::integer ? static_cast<double>(node.integer<int>(rule)) : node.number(rule);
}

Choice read_choice(const Node& list, const Rule& rule, VariableKind kind) {
  Choice choice;
  for (const Node& node : list.elements(Length::from_to(1, most_values))) {
    const double value = read_value(node, rule, kind);
    if (!choice.values.empty() && value <= choice.values.back())
      throw node.error(fmt::format("must exceed the value before it ({})", choice.values.back()));
    choice.values.push_back(value);
  }
  return choice;
}

Interval read_interval(ObjectReader& in, const Rule& rule, VariableKind kind) {
  Interval interval;
  interval.lower = read_value(in.at("lower"), rule, kind);
  const Node upper = in.at("upper");
  interval.upper = read_value(upper, rule, kind);
  if (interval.upper < interval.lower) throw upper.error(fmt::format("must not be below lower ({})", interval.lower));
  const auto step = in.find("step");
  if (!step) return interval;
  interval.step = read_value(*step, kind == VariableKind::integer ? Rule::at_least(1) : positive, kind);
  const double range = interval.upper - interval.lower;
  if (interval.step > range) throw step->error(fmt::format("must not exceed upper - lower ({})", range));
  if (range / interval.step > most_values) throw step->error(fmt::format("must make at most {} values", most_values));
  return interval;
}

// {"lower", "upper", "step"} or {"values": [...]}.
std::variant<Interval, Choice> read_range(ObjectReader& in, const Rule& rule, VariableKind kind) {
  if (in.one_of({"lower", "values"}) == "lower") return read_interval(in, rule, kind);
  return read_choice(in.at("values"), rule, kind);
}

ConfigurationVariable read_configurations(const Node& node) {
  return read_object(node, [](ObjectReader& in) {
    ConfigurationVariable variable;
    for (const Node& word : in.elements("values", Length::at_least(1))) {
      const actuator::Configuration value = read_configuration(word);
      if (std::ranges::count(variable.values, value) > 0) throw word.error("must not be there twice");
      variable.values.push_back(value);
    }
    return variable;
  });
}

// {"values": ["N42", "N52"]}.
ParameterVariable read_named(const Node& node, const actuator::Parameter& parameter) {
  return read_object(node, [&parameter](ObjectReader& in) {
    Choice choice;
    for (const Node& word : in.elements("values", Length::at_least(1))) {
      const double value = read_name(word, parameter);
      if (std::ranges::count(choice.values, value) > 0) throw word.error("must not be there twice");
      choice.values.push_back(value);
    }
    return ParameterVariable{.parameter = &parameter, .range = std::move(choice)};
  });
}

StudyVariable read_variable(const Node& node, const std::string& name) {
  if (name == "configuration") return read_configurations(node);
  if (name == "current_A")
    return read_object(node, [](ObjectReader& in) {
      return CurrentVariable{read_range(in, current_rule(), VariableKind::continuous)};
    });
  const actuator::Parameter* parameter = actuator::find_parameter(name);
  if (parameter == nullptr) {
    std::vector<std::string> names{"configuration", "current_A"};
    for (const actuator::Parameter& known : actuator::parameters()) names.emplace_back(known.name);
    throw node.error_without_value("is not a variable of a design" + did_you_mean(name, names));
  }
  if (!parameter->names().empty()) return read_named(node, *parameter);
  return read_object(node, [parameter](ObjectReader& in) {
    const VariableKind kind = parameter->whole ? VariableKind::integer : VariableKind::continuous;
    return ParameterVariable{.parameter = parameter, .range = read_range(in, rule_of(*parameter), kind)};
  });
}

std::vector<StudyVariable> read_variables(const Node& node) {
  node.expect_object();
  std::vector<StudyVariable> variables;
  for (const std::string& name : node.keys()) variables.push_back(read_variable(*node.find(name), name));
  if (variables.empty()) throw node.error_without_value("needs at least one variable");
  return variables;
}

StudyObjective read_objective(const Node& node, QuantityTable& quantities) {
  return read_object(node, [&quantities](ObjectReader& in) {
    // British as everything is written, and American as many people type it.
    const std::string sense = in.one_of({"maximise", "minimise", "maximize", "minimize"});
    return StudyObjective{.quantity = read_quantity(in.at(sense), in, quantities),
                          .sense = sense.starts_with("max") ? Sense::maximise : Sense::minimise};
  });
}

std::vector<StudyObjective> read_objectives(const Node& node, QuantityTable& quantities) {
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

Limit read_limit(const Node& node, QuantityTable& quantities) {
  return read_object(node, [&quantities](ObjectReader& in) {
    Limit limit{.quantity = read_quantity(in.at("quantity"), in, quantities)};
    const std::string side = in.one_of({"at_most", "at_least"});
    limit.side = side == "at_most" ? Limit::Side::at_most : Limit::Side::at_least;
    limit.value = in.number(side, limit_rule);
    return limit;
  });
}

std::vector<Limit> read_limits(const Node& node, QuantityTable& quantities) {
  std::vector<Limit> limits;
  for (const Node& element : node.elements(Length::from_to(0, 4 * quantities.size()))) {
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

SearchOptions read_search(const Node& node) {
  return read_object(node, [](ObjectReader& in) {
    SearchOptions options;
    if (const auto algorithm = in.find("algorithm")) {
      try {
        options.algorithm = algorithm_named(algorithm->text());
      } catch (const std::invalid_argument& mistake) {
        throw algorithm->error_without_value(mistake.what());
      }
    }
    options.max_evaluations = static_cast<std::size_t>(in.integer_or<std::int64_t>(
        "max_evaluations", static_cast<std::int64_t>(options.max_evaluations), Rule::between(1, 1e9)));
    options.seed = static_cast<std::uint64_t>(in.integer_or<std::int64_t>("seed", 1, non_negative));
    return options;
  });
}

actuator::Design read_base(const Node& node, const actuator::EffectCatalogue& effects) {
  ActuatorFile file = read_actuator(node.path(), effects);
  if (!std::holds_alternative<actuator::Design>(file.content))
    throw node.error("must be a design (actuator/1): a lumped model has no geometry to vary");
  return std::get<actuator::Design>(std::move(file.content));
}

// A correction was fitted to the motions of one finger.
void require_corrected_geometry(const Study& study, const Node& actuator) {
  if (!study.base.as_built.torque_correction) return;
  for (const StudyVariable& variable : study.variables) {
    if (std::holds_alternative<CurrentVariable>(variable)) continue;
    const auto* number = std::get_if<ParameterVariable>(&variable);
    if (number != nullptr && number->parameter->section == "surroundings") continue;
    throw actuator.error_without_value(fmt::format(
        "has a nameless torque correction, which holds for the finger that was measured alone: {} must not vary",
        name_of(variable)));
  }
}

bool varies_current(const Study& study) {
  return std::ranges::any_of(study.variables,
                             [](const StudyVariable& v) { return std::holds_alternative<CurrentVariable>(v); });
}

void read_operation(const Node& node, Study& study) {
  ObjectReader in(node);
  read_operating_conditions(in, study.operating);
  if (varies_current(study)) {
    for (const std::string_view key : {"current_A", "share_of_current_limit"})
      if (const auto fixed = in.find(key))
        throw fixed->error_without_value("sets the current, which is a variable of this study too");
  } else if (in.one_of({"current_A", "share_of_current_limit"}) == "current_A") {
    study.current = FixedCurrent{in.number("current_A", current_rule())};
  } else {
    study.current = ShareOfLimit{in.number("share_of_current_limit", largest_share)};
  }
  in.finish();
}

Study read_study_file(const Document& document, const QuantityTable& quantities,
                      const actuator::EffectCatalogue& effects) {
  return read_object(document.root(), [&](ObjectReader& in) {
    in.literal("format", "study/1");
    Study study;
    study.quantities = quantities;
    study.name = in.text("name");
    (void)in.text_or("description", "");
    study.variables = read_variables(in.at("variables"));
    // Only a current that varies leaves nothing to say.
    const auto operation = varies_current(study) ? in.find("operating_point") : in.at("operating_point");
    if (operation) read_operation(*operation, study);
    study.objectives = read_objectives(in.at("objectives"), study.quantities);
    if (const auto limits = in.find("constraints")) study.limits = read_limits(*limits, study.quantities);
    if (!operation || !operation->find("cases")) study.operating.cases = poses_of_use(study);
    if (const auto search = in.find("search")) study.search = read_search(*search);
    study.base = read_base(in.at("actuator"), effects);
    require_corrected_geometry(study, in.at("actuator"));
    return study;
  });
}

}  // namespace

sizing::Study read_study(const std::filesystem::path& path, const QuantityTable& quantities,
                         const actuator::EffectCatalogue& effects) {
  return read_study_file(read_json(path), quantities, effects);
}

sizing::Study parse_study(std::string_view text, std::string file, const QuantityTable& quantities,
                          const actuator::EffectCatalogue& effects) {
  return read_study_file(parse_json(text, std::move(file)), quantities, effects);
}

}  // namespace coilwright::formats
