#include "coilwright/sizing/design_problem.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <utility>

#include "coilwright/winding/wire_gauge.hpp"

namespace coilwright::sizing {
namespace {

Variable numeric_variable(std::string name, const std::variant<Interval, Choice>& range, bool whole) {
  if (const Choice* choice = std::get_if<Choice>(&range))
    return {.name = std::move(name),
            .kind = VariableKind::integer,
            .lower = 0.0,
            .upper = static_cast<double>(choice->values.size()) - 1.0};
  const Interval& interval = std::get<Interval>(range);
  return {.name = std::move(name),
          .kind = whole ? VariableKind::integer : VariableKind::continuous,
          .lower = interval.lower,
          .upper = interval.upper,
          .step = interval.step};
}

struct SearchVariable {
  Variable operator()(const ParameterVariable& v) const {
    return numeric_variable(std::string(v.parameter->name), v.range, v.parameter->whole);
  }
  Variable operator()(const CurrentVariable& v) const { return numeric_variable("current_A", v.range, false); }
  Variable operator()(const ConfigurationVariable& v) const {
    return {.name = "configuration",
            .kind = VariableKind::categorical,
            .lower = 0.0,
            .upper = static_cast<double>(v.values.size()) - 1.0};
  }
};

double number_at(const std::variant<Interval, Choice>& range, double coordinate) {
  if (const Choice* choice = std::get_if<Choice>(&range))
    return choice->values[static_cast<std::size_t>(std::lround(coordinate))];
  return coordinate;
}

actuator::Configuration configuration_at(const ConfigurationVariable& variable, double coordinate) {
  return variable.values[static_cast<std::size_t>(std::lround(coordinate))];
}

double current_of(const Study& study, const actuator::Design& design, std::span<const double> point) {
  for (std::size_t i = 0; i < study.variables.size(); ++i)
    if (const auto* current = std::get_if<CurrentVariable>(&study.variables[i]))
      return number_at(current->range, point[i]);
  if (const auto* fixed = std::get_if<FixedCurrent>(&study.current)) return fixed->current;
  return std::get<ShareOfLimit>(study.current).share * winding::gauge(design.coil.wire_gauge).chassis_ampacity;
}

// What one limit or objective asks of a candidate; a quantity that does not exist makes the design a failed one.
NotEvaluated missing(const Quantity& quantity, const Candidate& candidate) {
  const simulation::Heat& heat = candidate.performance.heat;
  const double rms = std::abs(candidate.point.current) * std::sqrt(candidate.point.duty);
  if (!heat.coil_temperature)
    return {
        .reason = fmt::format("{} has no value: thermal runaway above {:.4g} A", quantity.name, heat.runaway_current),
        .infeasibility = rms / heat.runaway_current};
  return {.reason = fmt::format("{} has no value: the current does not move the finger", quantity.name),
          .infeasibility = 1.0};
}

}  // namespace

DesignProblem::DesignProblem(Study study) : study_(std::move(study)) {
  variables_.reserve(study_.variables.size());
  for (const StudyVariable& variable : study_.variables) variables_.push_back(std::visit(SearchVariable{}, variable));
}

actuator::Design DesignProblem::design_at(std::span<const double> point) const {
  actuator::Design design = study_.base;
  for (std::size_t i = 0; i < study_.variables.size(); ++i) {
    if (const auto* number = std::get_if<ParameterVariable>(&study_.variables[i])) {
      number->parameter->set(design, number_at(number->range, point[i]) / number->parameter->denominator);
    } else if (const auto* layout = std::get_if<ConfigurationVariable>(&study_.variables[i])) {
      design.layout = actuator::layout_of(configuration_at(*layout, point[i]));
    }
  }
  return design;
}

std::variant<EvaluatedDesign, NotEvaluated> DesignProblem::evaluate(std::span<const double> point) const {
  actuator::Design design = design_at(point);
  std::variant<actuator::Assembly, actuator::Misfits> assembled = actuator::assemble(design);
  if (const auto* misfits = std::get_if<actuator::Misfits>(&assembled)) {
    double excess = 0.0;
    for (const actuator::Misfit& misfit : *misfits) excess += misfit.excess;
    return NotEvaluated{.reason = misfits->front().rule, .infeasibility = 1.0 + excess};
  }
  actuator::Assembly assembly = std::get<actuator::Assembly>(std::move(assembled));
  const simulation::OperatingPoint operating{.current = current_of(study_, design, point), .duty = study_.duty};
  std::variant<simulation::Performance, simulation::NoPerformance> performance =
      simulation::performance_of(design, assembly, operating);
  if (const auto* none = std::get_if<simulation::NoPerformance>(&performance))
    return NotEvaluated{.reason = none->reason, .infeasibility = 1.0};
  return EvaluatedDesign{.design = std::move(design),
                         .assembly = std::move(assembly),
                         .point = operating,
                         .performance = std::get<simulation::Performance>(std::move(performance))};
}

Problem DesignProblem::problem() const {
  Problem problem;
  problem.variables = variables_;
  for (const StudyObjective& objective : study_.objectives)
    problem.objectives.push_back({.name = std::string(objective.quantity->name), .sense = objective.sense});
  for (const Limit& limit : study_.limits) problem.constraints.push_back(name_of(limit));
  problem.evaluate = [this](std::span<const double> point) {
    Evaluation out;
    const auto fail = [&out](const NotEvaluated& why) {
      out = {.objectives = {}, .constraints = {}, .failure = why.reason, .infeasibility = why.infeasibility};
      return out;
    };
    const std::variant<EvaluatedDesign, NotEvaluated> result = evaluate(point);
    if (const auto* why = std::get_if<NotEvaluated>(&result)) return fail(*why);
    const Candidate candidate = std::get<EvaluatedDesign>(result).candidate();
    for (const StudyObjective& objective : study_.objectives) {
      const std::optional<double> value = objective.quantity->get(candidate);
      if (!value) return fail(missing(*objective.quantity, candidate));
      out.objectives.push_back(*value);
    }
    for (const Limit& limit : study_.limits) {
      const std::optional<double> value = limit.quantity->get(candidate);
      if (!value) return fail(missing(*limit.quantity, candidate));
      const double scale = limit.value != 0.0 ? std::abs(limit.value) : limit.quantity->scale;
      out.constraints.push_back(-margin(limit, *value) / scale);
    }
    return out;
  };
  return problem;
}

std::variant<double, std::string> DesignProblem::value_of(std::size_t variable, double coordinate) const {
  const StudyVariable& which = study_.variables[variable];
  if (const auto* number = std::get_if<ParameterVariable>(&which)) return number_at(number->range, coordinate);
  if (const auto* current = std::get_if<CurrentVariable>(&which)) return number_at(current->range, coordinate);
  return std::string(actuator::name_of(configuration_at(std::get<ConfigurationVariable>(which), coordinate)));
}

std::size_t DesignProblem::point_count() const {
  std::size_t count = 1;
  for (const StudyVariable& variable : study_.variables) {
    const std::optional<std::size_t> values = value_count(variable);
    if (!values)
      throw std::invalid_argument(
          fmt::format("{} has no step: a sweep needs a list, a step or whole numbers", name_of(variable)));
    if (*values > 0 && count > std::size_t{1'000'000'000'000} / *values)
      throw std::invalid_argument("a sweep may have at most 1e12 designs");
    count *= *values;
  }
  return count;
}

std::vector<double> DesignProblem::point(std::size_t index) const {
  std::vector<double> out(variables_.size());
  for (std::size_t i = variables_.size(); i-- > 0;) {
    const std::size_t values = *value_count(study_.variables[i]);
    const double k = static_cast<double>(index % values);
    index /= values;
    const double step = variables_[i].step > 0.0 ? variables_[i].step : 1.0;
    out[i] = variables_[i].lower + k * step;
  }
  return out;
}

}  // namespace coilwright::sizing
