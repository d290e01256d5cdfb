#include "formats/study/study_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "coilwright/actuator/design/parameters.hpp"
#include "coilwright/text/json/object_reader.hpp"
#include "coilwright/text/spelling.hpp"
#include "formats/actuator/actuator_reader.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using namespace sizing;

// Bounds far beyond any hardware and any search, and near enough that nothing overflows.
constexpr std::size_t most_values = 1'000'000;  // of one variable

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
  if (interval.step > range) throw step->error(fmt::format("must not exceed upper - lower ({:.12g})", range));
  if (range / interval.step > most_values) throw step->error(fmt::format("must make at most {} values", most_values));
  return interval;
}

// {"lower", "upper", "step"} or {"values": [...]}.
std::variant<Interval, Choice> read_range(ObjectReader& in, const Rule& rule, VariableKind kind) {
  if (in.one_of({"lower", "values"}) == "lower") return read_interval(in, rule, kind);
  return read_choice(in.at("values"), rule, kind);
}

// A row of coils and magnets under what files call it: the letter of a configuration, or its parts in words.
NamedLayout read_configuration_value(const Node& node) {
  const actuator::Configuration letter = read_configuration(node);
  return {.name = std::string(actuator::name_of(letter)), .layout = actuator::layout_of(letter)};
}

// "C", ["coil", "magnet", "coil"], or {"layout": [...], "polarity": [...]}.
NamedLayout read_layout_value(const Node& node) {
  if (node.kind() == Node::Kind::text) return read_configuration_value(node);
  actuator::Layout layout =
      node.kind() == Node::Kind::array
          ? read_row(node, std::nullopt)
          : read_object(node, [](ObjectReader& in) { return read_row(in.at("layout"), in.find("polarity")); });
  return {.name = text_of(layout), .layout = std::move(layout)};
}

// {"values": [...]} of rows of coils and magnets.
template <class ReadValue>
LayoutVariable read_layouts(const Node& node, const std::string& name, const ReadValue& read_value) {
  return read_object(node, [&](ObjectReader& in) {
    LayoutVariable variable{.name = name, .values = {}};
    for (const Node& element : in.elements("values", Length::at_least(1))) {
      NamedLayout value = read_value(element);
      if (std::ranges::count(variable.values, value.layout, &NamedLayout::layout) > 0)
        throw element.kind() == Node::Kind::text ? element.error("must not be there twice")
                                                 : element.error_without_value("must not be there twice");
      variable.values.push_back(std::move(value));
    }
    return variable;
  });
}

constexpr std::array layout_names{"configuration", "layout", "polarity"};

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

StudyVariable read_variable(const Node& node, const std::string& name, const std::vector<BlockVariable>& of_blocks) {
  if (name == "configuration") return read_layouts(node, name, read_configuration_value);
  if (name == "layout") return read_layouts(node, name, read_layout_value);
  if (name == "polarity") return LayoutVariable{.name = name, .values = {}};  // of a row that is read later
  if (name == "current_A")
    return read_object(
        node, [](ObjectReader& in) { return CurrentVariable{read_range(in, current_rule, VariableKind::continuous)}; });
  if (const auto found = std::ranges::find(of_blocks, name, &BlockVariable::name); found != of_blocks.end())
    return read_object(node, [&](ObjectReader& in) {
      return SettingVariable{
          .name = name, .base = found->base, .range = read_range(in, found->rule, VariableKind::continuous)};
    });
  const actuator::Parameter* parameter = actuator::find_parameter(name);
  if (parameter == nullptr) {
    if (const auto rule = missing_block(name, of_blocks)) throw node.error_without_value(*rule);
    std::vector<std::string> names(layout_names.begin(), layout_names.end());
    names.emplace_back("current_A");
    for (const BlockVariable& known : of_blocks) names.push_back(known.name);
    for (const actuator::Parameter& known : actuator::parameters()) names.emplace_back(known.name);
    throw node.error_without_value("is not a variable of a design" + did_you_mean(name, names));
  }
  if (!parameter->names().empty()) return read_named(node, *parameter);
  return read_object(node, [parameter](ObjectReader& in) {
    const VariableKind kind = parameter->whole ? VariableKind::integer : VariableKind::continuous;
    return ParameterVariable{.parameter = parameter, .range = read_range(in, rule_of(*parameter), kind)};
  });
}

// Two variables that set the same: which of them would count?
void require_compatible(const Node& node, const StudyVariable& one, const StudyVariable& other) {
  if (std::holds_alternative<LayoutVariable>(one) && std::holds_alternative<LayoutVariable>(other))
    throw node.error_without_value(
        fmt::format("must not vary beside \"{}\": give whole rows, as values of \"layout\" ({{\"layout\": [...], "
                    "\"polarity\": [...]}})",
                    name_of(one)));
  const auto* first = std::get_if<ParameterVariable>(&one);
  const auto* second = std::get_if<ParameterVariable>(&other);
  if (first == nullptr || second == nullptr) return;
  if (const auto conflict = conflict_between(*second->parameter, *first->parameter))
    throw node.error_without_value(*conflict);
}

}  // namespace

std::vector<StudyVariable> read_variables(const Node& node, const std::vector<BlockVariable>& of_blocks) {
  node.expect_object();
  std::vector<StudyVariable> variables;
  for (const std::string& name : node.keys()) {
    variables.push_back(read_variable(*node.find(name), name, of_blocks));
    for (std::size_t i = 0; i + 1 < variables.size(); ++i)
      require_compatible(*node.find(name), variables[i], variables.back());
  }
  if (variables.empty()) throw node.error_without_value("needs at least one variable");
  return variables;
}

LayoutVariable read_polarities(const Node& node, const actuator::Layout& base) {
  return read_layouts(node, "polarity", [&base](const Node& element) {
    actuator::Layout layout = base;
    read_polarity(element, layout);
    return NamedLayout{.name = text_of(layout), .layout = std::move(layout)};
  });
}

}  // namespace coilwright::formats
