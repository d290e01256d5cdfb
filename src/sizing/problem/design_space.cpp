#include "sizing/problem/design_space.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace coilwright::sizing {
namespace {

// Twelve decimals after the first of the range: far above rounding, and far below what hardware or an objective could
// tell apart. A difference quotient over 1e-6 of the range errs by a millionth of itself.
constexpr double decimals = 12;
// Above this many units of the last decimal, doubles are no finer than it.
constexpr double most_units = 4e15;

// `value` rounded to a decimal for a variable of that range. As a quotient of whole numbers it is the double nearest to
// the decimal, so that 0.3 stays 0.3.
double with_decimals_of(double value, double range) {
  if (!(range > 0)) return value;
  const double exponent = decimals - std::floor(std::log10(range));
  const double unit = std::pow(10.0, std::abs(exponent));
  if (exponent < 0) return std::round(value / unit) * unit;
  const double units = value * unit;
  return std::abs(units) < most_units ? std::round(units) / unit : value;
}

// 0 (not countable) if the product overflows, and from then on.
std::uint64_t times(std::uint64_t count, double factor) {
  constexpr auto largest = static_cast<double>(std::numeric_limits<std::int64_t>::max());
  return static_cast<double>(count) * factor < largest ? count * static_cast<std::uint64_t>(factor) : 0;
}

}  // namespace

double grid_step(const Variable& variable) {
  return variable.step > 0 || variable.kind == VariableKind::continuous ? variable.step : 1.0;
}

double last_grid_index(const Variable& variable) {
  // 1e-9 of a step: bounds and step come from decimal text, so their quotient misses a whole number by rounding.
  return std::floor((variable.upper - variable.lower) / grid_step(variable) + 1e-9);
}

double nearest_legal(const Variable& variable, double value) {
  const double step = grid_step(variable);
  if (step == 0) {
    const double rounded = with_decimals_of(value, variable.upper - variable.lower);
    return std::clamp(rounded, variable.lower, variable.upper) + 0.0;  // + 0.0: one zero, not two
  }
  const double index = std::clamp(std::round((value - variable.lower) / step), 0.0, last_grid_index(variable));
  return std::min(variable.lower + index * step, variable.upper) + 0.0;
}

std::vector<double> nearest_legal_point(const std::vector<Variable>& variables, std::span<const double> point) {
  std::vector<double> legal(variables.size());
  for (std::size_t i = 0; i < legal.size(); ++i) legal[i] = nearest_legal(variables[i], point[i]);
  return legal;
}

DesignSpace::DesignSpace(const std::vector<Variable>& variables) : variables_{variables} {
  for (std::size_t i = 0; i < variables_.size(); ++i) {
    const Variable& variable = variables_[i];
    const double step = grid_step(variable);
    if (variable.lower == variable.upper || (step > 0 && last_grid_index(variable) == 0)) continue;
    const double levels = step > 0 ? last_grid_index(variable) + 1 : 0;
    design_count_ = times(design_count_, levels);
    if (variable.kind == VariableKind::categorical) {
      categorical_.push_back(i);
      level_counts_.push_back(static_cast<std::uint64_t>(levels));
      combinations_ *= level_counts_.back();
      continue;
    }
    ordered_.push_back(i);
    const double range = variable.upper - variable.lower;
    axes_.push_back({.spacing = step / range, .ceiling = step > 0 ? std::min(1.0, (levels - 1) * step / range) : 1.0});
    has_grid_ = has_grid_ || step > 0;
  }
}

std::vector<double> DesignSpace::snapped(std::span<const double> unit) const {
  std::vector<double> result(unit.begin(), unit.end());
  for (std::size_t axis = 0; axis < result.size(); ++axis) {
    const Axis& grid = axes_[axis];
    if (grid.spacing > 0) result[axis] = std::round(result[axis] / grid.spacing) * grid.spacing;
    result[axis] = std::clamp(result[axis], 0.0, grid.ceiling);
  }
  return result;
}

std::vector<double> DesignSpace::point(std::span<const double> unit, std::uint64_t combination) const {
  std::vector<double> result(variables_.size());
  for (std::size_t i = 0; i < variables_.size(); ++i) result[i] = variables_[i].lower + 0.0;
  for (std::size_t axis = 0; axis < ordered_.size(); ++axis) {
    const Variable& variable = variables_[ordered_[axis]];
    result[ordered_[axis]] = nearest_legal(variable, std::lerp(variable.lower, variable.upper, unit[axis]));
  }
  for (const std::size_t i : categorical_) {
    const auto levels = static_cast<std::uint64_t>(variables_[i].upper) + 1;
    result[i] = static_cast<double>(combination % levels);
    combination /= levels;
  }
  return result;
}

std::vector<double> DesignSpace::unit(std::span<const double> point) const {
  std::vector<double> result(ordered_.size());
  for (std::size_t axis = 0; axis < ordered_.size(); ++axis) {
    const Variable& variable = variables_[ordered_[axis]];
    result[axis] = (point[ordered_[axis]] - variable.lower) / (variable.upper - variable.lower);
  }
  return result;
}

std::uint64_t DesignSpace::combination(std::span<const double> point) const {
  std::uint64_t result = 0;
  for (auto it = categorical_.rbegin(); it != categorical_.rend(); ++it) {
    result = result * (static_cast<std::uint64_t>(variables_[*it].upper) + 1) + static_cast<std::uint64_t>(point[*it]);
  }
  return result;
}

}  // namespace coilwright::sizing
