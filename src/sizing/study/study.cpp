#include "coilwright/sizing/study/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <span>
#include <stdexcept>
#include <utility>

#include "sizing/problem/design_space.hpp"

namespace coilwright::sizing {
namespace {

struct NameOf {
  std::string operator()(const ParameterVariable& variable) const { return std::string(variable.parameter->name); }
  std::string operator()(const CurrentVariable&) const { return "current_A"; }
  std::string operator()(const LayoutVariable& variable) const { return variable.name; }
  std::string operator()(const SettingVariable& variable) const { return variable.name; }
};

Variable numeric_variable(std::string name, const std::variant<Interval, Choice>& range, VariableKind kind) {
  if (const Choice* choice = std::get_if<Choice>(&range))
    return {.name = std::move(name),
            .kind = VariableKind::integer,
            .lower = 0.0,
            .upper = static_cast<double>(choice->values.size()) - 1.0};
  const Interval& interval = std::get<Interval>(range);
  return {
      .name = std::move(name), .kind = kind, .lower = interval.lower, .upper = interval.upper, .step = interval.step};
}

struct AsSearchVariable {
  Variable operator()(const ParameterVariable& variable) const {
    if (!variable.parameter->names().empty())  // materials have no order, as layouts have none
      return {.name = std::string(variable.parameter->name),
              .kind = VariableKind::categorical,
              .lower = 0.0,
              .upper = static_cast<double>(std::get<Choice>(variable.range).values.size()) - 1.0};
    return numeric_variable(std::string(variable.parameter->name), variable.range,
                            variable.parameter->whole ? VariableKind::integer : VariableKind::continuous);
  }
  Variable operator()(const CurrentVariable& variable) const {
    return numeric_variable("current_A", variable.range, VariableKind::continuous);
  }
  Variable operator()(const LayoutVariable& variable) const {
    return {.name = variable.name,
            .kind = VariableKind::categorical,
            .lower = 0.0,
            .upper = static_cast<double>(variable.values.size()) - 1.0};
  }
  Variable operator()(const SettingVariable& variable) const {
    return numeric_variable(variable.name, variable.range, VariableKind::continuous);
  }
};

std::size_t index_of(double coordinate) {
  return static_cast<std::size_t>(std::lround(coordinate));
}

// On a grid the decimal that is meant: 0.9, where 0.7 + 0.2 gives 0.8999999999999999. The sum is off by two units in
// the last place, so by less than half of the fourteenth digit.
double without_rounding(double value) {
  constexpr int digits = 14;
  std::array<char, 32> text{};
  const auto written =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::scientific, digits - 1);
  double rounded{};
  std::from_chars(text.data(), written.ptr, rounded);
  return rounded;
}

double number_at(const std::variant<Interval, Choice>& range, double coordinate) {
  if (const Choice* choice = std::get_if<Choice>(&range)) return choice->values[index_of(coordinate)];
  return std::get<Interval>(range).step > 0.0 ? without_rounding(coordinate) : coordinate;
}

struct ValueAt {
  double coordinate;
  VariableValue operator()(const ParameterVariable& variable) const {
    const double number = number_at(variable.range, coordinate);
    const std::span<const std::string_view> names = variable.parameter->names();
    if (names.empty()) return number;
    return names[index_of(number)];
  }
  VariableValue operator()(const CurrentVariable& variable) const { return number_at(variable.range, coordinate); }
  VariableValue operator()(const LayoutVariable& variable) const {
    return std::string_view(variable.values[index_of(coordinate)].name);
  }
  VariableValue operator()(const SettingVariable& variable) const { return number_at(variable.range, coordinate); }
};

}  // namespace

ParameterVariable parameter_variable(std::string_view name, std::variant<Interval, Choice> range) {
  const actuator::Parameter* parameter = actuator::find_parameter(name);
  if (parameter == nullptr) throw std::invalid_argument(fmt::format("no parameter of a design is called \"{}\"", name));
  const std::size_t names = parameter->names().size();
  if (names > 0) {
    const Choice* choice = std::get_if<Choice>(&range);
    const auto known = [names](double index) {
      return index >= 0.0 && index < static_cast<double>(names) && index == std::floor(index);
    };
    if (choice == nullptr || !std::ranges::all_of(choice->values, known))
      throw std::invalid_argument(fmt::format("{} has names: give a list of their indices, 0 to {}", name, names - 1));
  }
  return {.parameter = parameter, .range = std::move(range)};
}

LayoutVariable configuration_variable(std::vector<actuator::Configuration> values) {
  LayoutVariable out{.name = "configuration", .values = {}};
  for (const actuator::Configuration each : values)
    out.values.push_back({.name = std::string(actuator::name_of(each)), .layout = actuator::layout_of(each)});
  return out;
}

std::string name_of(const StudyVariable& variable) {
  return std::visit(NameOf{}, variable);
}

Variable search_variable(const StudyVariable& variable) {
  return std::visit(AsSearchVariable{}, variable);
}

std::optional<std::size_t> value_count(const StudyVariable& variable) {
  const Variable searched = search_variable(variable);
  if (searched.lower == searched.upper) return 1;
  if (grid_step(searched) == 0.0) return std::nullopt;
  return static_cast<std::size_t>(last_grid_index(searched)) + 1;
}

VariableValue value_at(const StudyVariable& variable, double coordinate) {
  return std::visit(ValueAt{coordinate}, variable);
}

std::optional<double> coordinate_of(const StudyVariable& variable, const VariableValue& value) {
  const Variable searched = search_variable(variable);
  const auto has_value = [&](double coordinate) { return value_at(variable, coordinate) == value; };
  // Lists and names have their indices as coordinates, which say nothing of the value; a range has the value itself.
  const auto* number = std::get_if<double>(&value);
  if (number != nullptr && std::isfinite(*number)) {
    const double near = nearest_legal(searched, *number);
    if (has_value(near)) return near;
  }
  if (searched.kind == VariableKind::continuous) return std::nullopt;
  for (double index = 0.0; searched.lower == 0.0 && index <= searched.upper; ++index)
    if (has_value(index)) return index;
  return std::nullopt;
}

double coordinate_near(double value, const std::variant<Interval, Choice>& range) {
  const Choice* choice = std::get_if<Choice>(&range);
  if (choice == nullptr) return value;
  const auto distance = [value](double each) { return std::abs(each - value); };
  return static_cast<double>(std::ranges::min_element(choice->values, {}, distance) - choice->values.begin());
}

std::optional<double> nearest_coordinate(const StudyVariable& variable, const VariableValue& value) {
  if (const std::optional<double> exact = coordinate_of(variable, value)) return exact;
  const Variable searched = search_variable(variable);
  const auto* number = std::get_if<double>(&value);
  if (number == nullptr || searched.kind == VariableKind::categorical) return std::nullopt;
  const auto near = [number](const auto& each) {
    if constexpr (requires { each.range; }) return coordinate_near(*number, each.range);
    return *number;  // a layout, which is categorical
  };
  return nearest_legal(searched, std::visit(near, variable));
}

double number_at(const ParameterVariable& variable, double coordinate) {
  return number_at(variable.range, coordinate);
}

std::string name_of(const Limit& limit) {
  return fmt::format("{} {} {}", limit.quantity.name, limit.side == Limit::Side::at_most ? "<=" : ">=", limit.value);
}

double margin(const Limit& limit, double value) {
  return limit.side == Limit::Side::at_most ? limit.value - value : value - limit.value;
}

double scale_of(const Limit& limit) {
  return limit.value != 0.0 ? std::abs(limit.value) : limit.quantity.scale;
}

actuator::HeldCases poses_of_use(const Study& study) {
  std::optional<actuator::HeldCases> pose;
  for (const StudyObjective& objective : study.objectives) pose = simulation::either(pose, objective.quantity.pose);
  for (const Limit& limit : study.limits) pose = simulation::either(pose, limit.quantity.pose);
  return pose.value_or(actuator::HeldCases::both);
}

}  // namespace coilwright::sizing
