#include "coilwright/sizing/study.hpp"

#include <fmt/format.h>

#include <cmath>

namespace coilwright::sizing {
namespace {

struct NameOf {
  std::string operator()(const ParameterVariable& variable) const { return std::string(variable.parameter->name); }
  std::string operator()(const CurrentVariable&) const { return "current_A"; }
  std::string operator()(const ConfigurationVariable&) const { return "configuration"; }
};

std::optional<std::size_t> count(const std::variant<Interval, Choice>& range, bool whole) {
  if (const Choice* choice = std::get_if<Choice>(&range)) return choice->values.size();
  const Interval& interval = std::get<Interval>(range);
  const double step = interval.step > 0.0 ? interval.step : (whole ? 1.0 : 0.0);
  if (step == 0.0) return interval.lower == interval.upper ? std::optional<std::size_t>(1) : std::nullopt;
  // As the search's own grid: a last value within a rounding of the upper bound counts.
  return static_cast<std::size_t>(std::floor((interval.upper - interval.lower) / step * (1.0 + 1e-12))) + 1;
}

struct CountOf {
  std::optional<std::size_t> operator()(const ParameterVariable& variable) const {
    return count(variable.range, variable.parameter->whole);
  }
  std::optional<std::size_t> operator()(const CurrentVariable& variable) const { return count(variable.range, false); }
  std::optional<std::size_t> operator()(const ConfigurationVariable& variable) const { return variable.values.size(); }
};

}  // namespace

std::string name_of(const StudyVariable& variable) {
  return std::visit(NameOf{}, variable);
}

std::optional<std::size_t> value_count(const StudyVariable& variable) {
  return std::visit(CountOf{}, variable);
}

std::string name_of(const Limit& limit) {
  return fmt::format("{} {} {}", limit.quantity->name, limit.side == Limit::Side::at_most ? "<=" : ">=", limit.value);
}

double margin(const Limit& limit, double value) {
  return limit.side == Limit::Side::at_most ? limit.value - value : value - limit.value;
}

}  // namespace coilwright::sizing
