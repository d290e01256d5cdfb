#include "coilwright/archive/row.hpp"

#include <string_view>

namespace coilwright::archive {
namespace {

Value stored(const sizing::VariableValue& value) {
  if (const auto* number = std::get_if<double>(&value)) return *number;
  return std::string(std::get<std::string_view>(value));
}

sizing::VariableValue seen(const Value& value) {
  if (const auto* number = std::get_if<double>(&value)) return *number;
  return std::string_view(std::get<std::string>(value));
}

}  // namespace

std::vector<Value> values_of(const sizing::Study& study, std::span<const double> point) {
  std::vector<Value> values;
  values.reserve(point.size());
  for (std::size_t i = 0; i < point.size(); ++i)
    values.push_back(stored(sizing::value_at(study.variables.at(i), point[i])));
  return values;
}

std::optional<std::vector<double>> point_of(const sizing::Study& study, std::span<const Value> values) {
  if (values.size() != study.variables.size()) return std::nullopt;
  std::vector<double> point;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::optional<double> coordinate = sizing::coordinate_of(study.variables[i], seen(values[i]));
    if (!coordinate) return std::nullopt;
    point.push_back(*coordinate);
  }
  return point;
}

}  // namespace coilwright::archive
