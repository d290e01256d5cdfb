#include "coilwright/sizing/study/design_problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

#include "coilwright/actuator/design/current_limit.hpp"
#include "coilwright/units/unit.hpp"
#include "sizing/problem/design_space.hpp"
#include "sizing/study/base_current.hpp"
#include "sizing/study/early_limits.hpp"
#include "sizing/study/evaluate_design.hpp"

namespace coilwright::sizing {
namespace {

// The current of a design, as far as it is known before it is assembled: `varied` where a variable sets it, NaN where
// the assembly decides.
double current_before(const Study& study, const actuator::Design& design, double varied) {
  if (const auto* fixed = std::get_if<FixedCurrent>(&study.current)) return fixed->current;
  if (const auto* share = std::get_if<ShareOfLimit>(&study.current))
    return share->share * actuator::operating_current_limit(design);
  if (std::holds_alternative<DrivenCurrent>(study.current)) return std::numeric_limits<double>::quiet_NaN();
  return varied;
}

// The study's operating point for a design whose current no variable sets; `otherwise` where one does.
actuator::OperatingPoint operating_of(const Study& study, const actuator::Design& design,
                                      const actuator::Assembly& assembly, const simulation::Settings& settings,
                                      double otherwise) {
  actuator::OperatingPoint point = study.operating;
  point.current = current_before(study, design, otherwise);
  if (const auto* driven = std::get_if<DrivenCurrent>(&study.current)) {
    const DrivenCurrent::Drive drive = driven->drive(assembly, settings);
    point.current = drive.current;
    point.duty = drive.duty;
  }
  return point;
}

// The current that a variable sets at a point; nothing if none does.
std::optional<double> varied_current(const Study& study, std::span<const double> point) {
  for (std::size_t i = 0; i < study.variables.size(); ++i)
    if (std::holds_alternative<CurrentVariable>(study.variables[i]))
      return std::get<double>(value_at(study.variables[i], point[i]));
  return std::nullopt;
}

Evaluation failed(const NotEvaluated& why, std::vector<std::optional<double>> quantities) {
  return {.objectives = {},
          .constraints = {},
          .failure = why.reason,
          .infeasibility = why.infeasibility,
          .quantities = std::move(quantities)};
}

std::vector<std::optional<double>> values_of(const simulation::QuantityTable& quantities,
                                             const simulation::DesignView& design) {
  std::vector<std::optional<double>> values;
  values.reserve(quantities.size());
  for (const simulation::ResultQuantity& quantity : quantities) {
    values.push_back(quantity.value(design));
    if (values.back() && !std::isfinite(*values.back())) values.back().reset();
  }
  return values;
}

double constraint_of(const Limit& limit, double value) {
  return -margin(limit, value) / scale_of(limit);
}

// The coordinate of the study's own actuator in one variable. Where the current varies, the search begins with the
// chassis ampacity of the actuator's wire.
struct CoordinateOfBase {
  const actuator::Design& base;

  double operator()(const ParameterVariable& variable) const {
    const double value = variable.parameter->get(base);
    return coordinate_near(units::from_memory(value, variable.parameter->key), variable.range);
  }
  double operator()(const CurrentVariable& variable) const {
    return coordinate_near(wire_of(base.coil).chassis_ampacity, variable.range);
  }
  // The first of the list where the actuator's row of components is none of it.
  double operator()(const LayoutVariable& variable) const {
    const auto same = std::ranges::find(variable.values, base.layout, &NamedLayout::layout);
    return same == variable.values.end() ? 0.0 : static_cast<double>(same - variable.values.begin());
  }
  double operator()(const SettingVariable& variable) const { return coordinate_near(variable.base, variable.range); }
};

}  // namespace

DesignProblem::DesignProblem(Study study) {
  const bool varied = std::ranges::any_of(
      study.variables, [](const StudyVariable& v) { return std::holds_alternative<CurrentVariable>(v); });
  if (varied != std::holds_alternative<VariedCurrent>(study.current))
    throw std::invalid_argument("current: must be fixed or a variable, one of the two");
  for (const StudyObjective& objective : study.objectives) simulation::validate_quantity(objective.quantity);
  for (const Limit& limit : study.limits) simulation::validate_quantity(limit.quantity);
  if (const auto* driven = std::get_if<DrivenCurrent>(&study.current); driven != nullptr && !driven->drive)
    throw std::invalid_argument("current: the function that drives it must not be empty");
  std::vector<Variable> variables;
  variables.reserve(study.variables.size());
  for (const StudyVariable& variable : study.variables) variables.push_back(search_variable(variable));
  state_ = std::make_shared<const State>(State{.study = std::move(study), .variables = std::move(variables)});
}

actuator::Design DesignProblem::design_at(std::span<const double> point) const {
  actuator::Design design = study().base;
  for (std::size_t i = 0; i < study().variables.size(); ++i) {
    if (const auto* number = std::get_if<ParameterVariable>(&study().variables[i])) {
      const double value = number_at(*number, point[i]);
      number->parameter->set(design, units::to_memory(value, number->parameter->key));
    } else if (const auto* layout = std::get_if<LayoutVariable>(&study().variables[i])) {
      design.layout = layout->values[static_cast<std::size_t>(std::lround(point[i]))].layout;
    }
  }
  return design;
}

simulation::Settings DesignProblem::settings_at(std::span<const double> point) const {
  simulation::Settings settings;
  for (std::size_t i = 0; i < study().variables.size(); ++i)
    if (const auto* setting = std::get_if<SettingVariable>(&study().variables[i]))
      settings[setting->name] =
          units::to_memory(std::get<double>(value_at(study().variables[i], point[i])), setting->name);
  return settings;
}

DesignResult DesignProblem::evaluate(std::span<const double> point) const {
  return evaluate_design(
      design_at(point), settings_at(point),
      [&](const auto&... of) { return operating_of(study(), of..., varied_current(study(), point).value_or(0.0)); },
      study().driver);
}

DesignResult DesignProblem::evaluate_base() const {
  const auto at = [this](double current) {
    return evaluate_design(
        study().base, {}, [&](const auto&... of) { return operating_of(study(), of..., current); }, study().driver);
  };
  const auto varied = std::ranges::find_if(
      study().variables, [](const StudyVariable& v) { return std::holds_alternative<CurrentVariable>(v); });
  if (varied == study().variables.end()) return at(0.0);  // the study sets it
  return at(best_current(std::get<CurrentVariable>(*varied), study().objectives.front(),
                         [&](double current) { return assess(at(current)); }));
}

Evaluation DesignProblem::assess(const DesignResult& result) const {
  if (const auto* why = std::get_if<NotEvaluated>(&result)) return failed(*why, {});
  const simulation::DesignView design = std::get<EvaluatedDesign>(result).view();
  Evaluation out;
  out.quantities = values_of(study().quantities, design);
  for (const StudyObjective& objective : study().objectives) {
    const std::optional<double> value = objective.quantity.value(design);
    if (!value || !std::isfinite(*value))
      return failed(without_value(objective.quantity, design), std::move(out.quantities));
    out.objectives.push_back(*value);
  }
  for (const Limit& limit : study().limits) {
    const std::optional<double> value = limit.quantity.value(design);
    if (!value || !std::isfinite(*value))
      return failed(without_value(limit.quantity, design), std::move(out.quantities));
    out.constraints.push_back(constraint_of(limit, *value));
  }
  return out;
}

std::optional<Evaluation> DesignProblem::assess(std::vector<std::optional<double>> quantities) const {
  const auto value_of = [&](const simulation::ResultQuantity& asked) -> std::optional<double> {
    for (std::size_t i = 0; i < quantities.size() && i < study().quantities.size(); ++i)
      if (study().quantities[i].name == asked.name) return quantities[i];
    return std::nullopt;
  };
  Evaluation out;
  for (const StudyObjective& objective : study().objectives) {
    const std::optional<double> value = value_of(objective.quantity);
    if (!value) return std::nullopt;
    out.objectives.push_back(*value);
  }
  for (const Limit& limit : study().limits) {
    const std::optional<double> value = value_of(limit.quantity);
    if (!value) return std::nullopt;
    out.constraints.push_back(constraint_of(limit, *value));
  }
  out.quantities = std::move(quantities);
  return out;
}

Problem DesignProblem::problem() const {
  Problem problem;
  problem.variables = state_->variables;
  for (const StudyObjective& objective : study().objectives)
    problem.objectives.push_back({.name = objective.quantity.name, .sense = objective.sense});
  for (const Limit& limit : study().limits) problem.constraints.push_back(name_of(limit));
  problem.evaluate = [design_problem = *this](std::span<const double> point) {
    return design_problem.assess(design_problem.evaluate(point));
  };
  if (BreaksEarlyLimit breaks = early_limits(study())) {
    problem.excluded = [design_problem = *this, breaks = std::move(breaks)](std::span<const double> point) {
      const actuator::Design design = design_problem.design_at(point);
      return breaks(design, current_before(design_problem.study(), design,
                                           varied_current(design_problem.study(), point).value_or(0.0)));
    };
  }
  std::vector<double>& base = problem.starts.emplace_back();
  for (const StudyVariable& variable : study().variables)
    base.push_back(std::visit(CoordinateOfBase{study().base}, variable));
  problem.starts.insert(problem.starts.end(), study().starts.begin(), study().starts.end());
  return problem;
}

std::size_t DesignProblem::point_count() const {
  std::size_t count = 1;
  for (const StudyVariable& variable : study().variables) {
    const std::optional<std::size_t> values = value_count(variable);
    if (!values) throw std::invalid_argument(fmt::format("{} must have a step or a list of values", name_of(variable)));
    if (*values > max_grid_points / count)
      throw std::invalid_argument(fmt::format("a grid must have at most {} designs", max_grid_points));
    count *= *values;
  }
  return count;
}

std::vector<double> DesignProblem::point(std::size_t index) const {
  const std::vector<Variable>& variables = state_->variables;
  std::vector<double> out(variables.size());
  for (std::size_t i = variables.size(); i-- > 0;) {
    const std::size_t values = value_count(study().variables[i]).value();
    const auto k = static_cast<double>(index % values);
    index /= values;
    // The search's own rounding: a design found there and one found here are the same bits.
    out[i] = nearest_legal(variables[i], variables[i].lower + k * grid_step(variables[i]));
  }
  return out;
}

}  // namespace coilwright::sizing
