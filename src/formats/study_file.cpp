#include "coilwright/formats/study_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "coilwright/formats/actuator_file.hpp"
#include "coilwright/formats/json_document.hpp"
#include "coilwright/formats/object_reader.hpp"
#include "coilwright/formats/spelling.hpp"
#include "design_reader.hpp"

namespace coilwright::formats {
namespace {

using namespace sizing;

const Quantity& read_quantity(const Node& node) {
  if (const Quantity* quantity = find_quantity(node.text())) return *quantity;
  std::vector<std::string> names;
  for (const Quantity& quantity : quantities()) names.emplace_back(quantity.name);
  throw node.error("must be a quantity that evaluate prints" + did_you_mean(node.text(), names));
}

// {"lower", "upper", "step"} or {"values": [...]}.
std::variant<Interval, Choice> read_range(ObjectReader& in, const Rule& rule, bool whole) {
  const auto number = [&](const Node& node) {
    return whole ? static_cast<double>(node.integer<int>(rule)) : node.number(rule);
  };
  if (in.one_of({"lower", "values"}) == "values") {
    Choice choice;
    for (const Node& node : in.elements("values", Length::at_least(1))) {
      const double value = number(node);
      if (!choice.values.empty() && value <= choice.values.back())
        throw node.error(fmt::format("must exceed the value before it ({})", choice.values.back()));
      choice.values.push_back(value);
    }
    return choice;
  }
  Interval interval;
  interval.lower = number(in.at("lower"));
  const Node upper = in.at("upper");
  interval.upper = number(upper);
  if (interval.upper < interval.lower) throw upper.error(fmt::format("must not be below lower ({})", interval.lower));
  if (const auto step = in.find("step"))
    interval.step = whole ? step->integer<int>(Rule::at_least(1)) : step->number(positive);
  return interval;
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

StudyVariable read_variable(const Node& node, const std::string& name) {
  if (name == "configuration") return read_configurations(node);
  if (name == "current_A")
    return read_object(node, [](ObjectReader& in) { return CurrentVariable{read_range(in, finite, false)}; });
  const actuator::Parameter* parameter = actuator::find_parameter(name);
  if (parameter == nullptr) {
    std::vector<std::string> names{"configuration", "current_A"};
    for (const actuator::Parameter& known : actuator::parameters()) names.emplace_back(known.name);
    throw node.error_without_value("is not a variable of a design" + did_you_mean(name, names));
  }
  return read_object(node, [parameter](ObjectReader& in) {
    return ParameterVariable{.parameter = parameter, .range = read_range(in, rule_of(*parameter), parameter->whole)};
  });
}

std::vector<StudyVariable> read_variables(const Node& node) {
  node.expect_object();
  std::vector<StudyVariable> variables;
  for (const std::string& name : node.keys()) variables.push_back(read_variable(*node.find(name), name));
  if (variables.empty()) throw node.error_without_value("needs at least one variable");
  return variables;
}

StudyObjective read_objective(const Node& node) {
  return read_object(node, [](ObjectReader& in) {
    const std::string sense = in.one_of({"maximise", "minimise"});
    return StudyObjective{.quantity = &read_quantity(in.at(sense)),
                          .sense = sense == "maximise" ? Sense::maximise : Sense::minimise};
  });
}

std::vector<StudyObjective> read_objectives(const Node& node) {
  std::vector<StudyObjective> objectives;
  for (const Node& element : node.elements(Length::from_to(1, 3))) {
    objectives.push_back(read_objective(element));
    const auto same = [&](const StudyObjective& other) { return other.quantity == objectives.back().quantity; };
    if (std::ranges::count_if(objectives, same) > 1) throw element.error_without_value("asks for a quantity twice");
  }
  return objectives;
}

Limit read_limit(const Node& node) {
  return read_object(node, [](ObjectReader& in) {
    Limit limit{.quantity = &read_quantity(in.at("quantity"))};
    const std::string side = in.one_of({"at_most", "at_least"});
    limit.side = side == "at_most" ? Limit::Side::at_most : Limit::Side::at_least;
    limit.value = in.number(side);
    return limit;
  });
}

std::vector<Limit> read_limits(const Node& node) {
  std::vector<Limit> limits;
  for (const Node& element : node.elements()) {
    const Limit limit = read_limit(element);
    for (const Limit& other : limits) {
      if (other.quantity != limit.quantity) continue;
      if (other.side == limit.side) throw element.error_without_value("limits the same side of a quantity twice");
      const double low = limit.side == Limit::Side::at_least ? limit.value : other.value;
      const double high = limit.side == Limit::Side::at_least ? other.value : limit.value;
      if (low > high)
        throw element.error_without_value(
            fmt::format("contradicts an earlier limit: {} cannot be >= {} and <= {}", limit.quantity->name, low, high));
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

void read_operating_point(const Node& node, Study& study) {
  read_object(node, [&study, &node](ObjectReader& in) {
    const bool varied = std::ranges::any_of(
        study.variables, [](const StudyVariable& v) { return std::holds_alternative<CurrentVariable>(v); });
    study.duty = in.number_or("duty", 1.0, Rule::above(0.0).and_also(Rule::at_most(1.0)));
    if (varied) {
      if (in.find("current_A") || in.find("share_of_current_limit"))
        throw node.error_without_value("sets the current, which is a variable of this study too");
      return 0;
    }
    if (in.one_of({"current_A", "share_of_current_limit"}) == "current_A")
      study.current = FixedCurrent{in.number("current_A")};
    else
      study.current = ShareOfLimit{in.number("share_of_current_limit", positive)};
    return 0;
  });
}

}  // namespace

sizing::Study read_study(const std::filesystem::path& path) {
  const Document document = read_json(path);
  return read_object(document.root(), [](ObjectReader& in) {
    in.literal("format", "study/1");
    Study study;
    study.name = in.text("name");
    (void)in.text_or("description", "");
    study.variables = read_variables(in.at("variables"));
    read_operating_point(in.at("operating_point"), study);
    study.objectives = read_objectives(in.at("objectives"));
    if (const auto limits = in.find("constraints")) study.limits = read_limits(*limits);
    if (const auto search = in.find("search")) study.search = read_search(*search);
    const Node actuator_node = in.at("actuator");
    ActuatorFile actuator = read_actuator(actuator_node.path());
    if (!std::holds_alternative<actuator::Design>(actuator.content))
      throw actuator_node.error("must be a design (actuator/1): a lumped model has no geometry to vary");
    study.base = std::get<actuator::Design>(std::move(actuator.content));
    return study;
  });
}

}  // namespace coilwright::formats
