#include "coilwright/sizing/problem/problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <utility>

namespace coilwright::sizing {
namespace {

[[noreturn]] void reject(const std::string& field, const std::string& rule, const std::string& got) {
  throw std::invalid_argument(fmt::format("{}: {}; got {}", field, rule, got));
}

bool is_whole(double value) {
  return value == std::floor(value);
}

void validate_grid(const Variable& variable, const std::string& field) {
  const double step = variable.step;
  if (!std::isfinite(step) || step < 0) reject(field + ".step", "must be finite and >= 0", fmt::to_string(step));
  if (step > 0 && variable.upper > variable.lower && step > variable.upper - variable.lower) {
    reject(field + ".step", fmt::format("must not exceed the range {}", variable.upper - variable.lower),
           fmt::to_string(step));
  }
  if (variable.kind == VariableKind::continuous) return;
  if (!is_whole(variable.lower)) reject(field + ".lower", "must be whole", fmt::to_string(variable.lower));
  if (!is_whole(variable.upper)) reject(field + ".upper", "must be whole", fmt::to_string(variable.upper));
  if (!is_whole(step)) reject(field + ".step", "must be whole", fmt::to_string(step));
  if (variable.kind == VariableKind::integer) return;
  if (variable.lower != 0) reject(field + ".lower", "must be 0 for a categorical", fmt::to_string(variable.lower));
  if (step > 1) reject(field + ".step", "must be 0 or 1 for a categorical", fmt::to_string(step));
}

void validate_variable(const Variable& variable, std::size_t index) {
  const std::string field = fmt::format("variables[{}]", index);
  if (variable.name.empty()) reject(field + ".name", "must not be empty", "\"\"");
  if (!std::isfinite(variable.lower)) reject(field + ".lower", "must be finite", fmt::to_string(variable.lower));
  if (!std::isfinite(variable.upper)) reject(field + ".upper", "must be finite", fmt::to_string(variable.upper));
  if (variable.upper < variable.lower) {
    reject(field + ".upper", fmt::format("must be >= lower ({})", variable.lower), fmt::to_string(variable.upper));
  }
  validate_grid(variable, field);
}

void require_unique(const std::vector<std::string>& names, const char* field) {
  std::set<std::string> seen;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i].empty()) reject(fmt::format("{}[{}].name", field, i), "must not be empty", "\"\"");
    if (!seen.insert(names[i]).second) {
      reject(fmt::format("{}[{}].name", field, i), "must be unique", fmt::format("\"{}\" twice", names[i]));
    }
  }
}

Evaluation failed(std::string reason, double infeasibility, std::vector<std::optional<double>> quantities) {
  Evaluation evaluation;
  evaluation.failure = std::move(reason);
  evaluation.quantities = std::move(quantities);
  evaluation.infeasibility = std::isfinite(infeasibility) ? std::max(infeasibility, 0.0) : 1.0;
  return evaluation;
}

}  // namespace

void validate_problem(const Problem& problem) {
  if (problem.variables.empty()) reject("variables", "must name at least one", "none");
  std::vector<std::string> names;
  for (std::size_t i = 0; i < problem.variables.size(); ++i) {
    validate_variable(problem.variables[i], i);
    names.push_back(problem.variables[i].name);
  }
  require_unique(names, "variables");
  if (problem.objectives.empty()) reject("objectives", "must name at least one", "none");
  names.clear();
  for (const Objective& objective : problem.objectives) names.push_back(objective.name);
  require_unique(names, "objectives");
  require_unique(problem.constraints, "constraints");
  for (const std::vector<double>& start : problem.starts) {
    if (start.size() != problem.variables.size())
      reject("start", fmt::format("must have {} values", problem.variables.size()), fmt::to_string(start.size()));
    for (const double value : start)
      if (!std::isfinite(value)) reject("start", "must be finite", fmt::to_string(value));
  }
  if (!problem.evaluate) reject("evaluate", "must be callable", "an empty function");
}

Evaluation evaluate_checked(const Problem& problem, std::span<const double> point) {
  return checked(problem, problem.evaluate(point));
}

Evaluation checked(const Problem& problem, Evaluation evaluation) {
  if (!evaluation.failure.empty()) {
    return failed(std::move(evaluation.failure), evaluation.infeasibility, std::move(evaluation.quantities));
  }
  if (evaluation.objectives.size() != problem.objectives.size()) {
    throw std::logic_error(fmt::format("evaluate: must return {} objectives; got {}", problem.objectives.size(),
                                       evaluation.objectives.size()));
  }
  if (evaluation.constraints.size() != problem.constraints.size()) {
    throw std::logic_error(fmt::format("evaluate: must return {} constraints; got {}", problem.constraints.size(),
                                       evaluation.constraints.size()));
  }
  for (std::size_t i = 0; i < evaluation.objectives.size(); ++i) {
    const double value = evaluation.objectives[i];
    if (!std::isfinite(value)) {
      return failed(fmt::format("objective '{}' is not finite ({})", problem.objectives[i].name, value), 1.0,
                    std::move(evaluation.quantities));
    }
  }
  for (std::size_t i = 0; i < evaluation.constraints.size(); ++i) {
    const double value = evaluation.constraints[i];
    if (!std::isfinite(value)) {
      return failed(fmt::format("constraint '{}' is not finite ({})", problem.constraints[i], value), 1.0,
                    std::move(evaluation.quantities));
    }
  }
  evaluation.infeasibility = 0;
  return evaluation;
}

double violation(const Evaluation& evaluation) {
  if (!evaluation.failure.empty()) return evaluation.infeasibility;
  double sum = 0;
  for (const double value : evaluation.constraints) sum += std::max(value, 0.0);
  return sum;
}

bool is_feasible(const Evaluation& evaluation) {
  return evaluation.failure.empty() &&
         std::ranges::none_of(evaluation.constraints, [](double value) { return value > 0; });
}

std::vector<std::string> violated_by(const Problem& problem, const Evaluation& evaluation) {
  if (!evaluation.failure.empty()) return {evaluation.failure};
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < evaluation.constraints.size(); ++i) {
    if (evaluation.constraints[i] > 0) order.emplace_back(-evaluation.constraints[i], i);
  }
  std::ranges::sort(order);
  std::vector<std::string> names;
  for (const auto& entry : order) names.push_back(problem.constraints[entry.second]);
  return names;
}

}  // namespace coilwright::sizing
