#pragma once

#include <memory>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "coilwright/sizing/study.hpp"

namespace coilwright::sizing {

/// A study's design at one point of its search space, with what it does; or why it cannot be evaluated.
struct EvaluatedDesign {
  actuator::Design design;
  actuator::Assembly assembly;
  simulation::OperatingPoint point;
  simulation::Performance performance;

  [[nodiscard]] Candidate candidate() const {
    return {.design = design, .assembly = assembly, .point = point, .performance = performance};
  }
};
struct NotEvaluated {
  std::string reason;
  double infeasibility{};  ///< grows away from what can be evaluated, > 0
};

/// A study as the search sees it. Points of the search hold a value per study variable in the unit of its name, but for
/// lists and configurations, whose coordinate is the index of the value.
class DesignProblem {
 public:
  explicit DesignProblem(Study study);

  [[nodiscard]] const Study& study() const noexcept { return study_; }

  /// The problem to hand to search() or pareto(). It refers to this object, which must outlive it.
  [[nodiscard]] Problem problem() const;

  /// The design at a point: the study's base with the variables set.
  [[nodiscard]] actuator::Design design_at(std::span<const double> point) const;

  /// Everything about a point. Pure.
  [[nodiscard]] std::variant<EvaluatedDesign, NotEvaluated> evaluate(std::span<const double> point) const;

  /// A point's value of one variable as files write it: a number, or the letter of a configuration.
  [[nodiscard]] std::variant<double, std::string> value_of(std::size_t variable, double coordinate) const;

  /// All points of a study whose variables are all lists, grids or whole numbers, one by one: point `index` of
  /// point_count(), the last variable fastest. Throws std::invalid_argument naming a variable that is continuous.
  [[nodiscard]] std::size_t point_count() const;
  [[nodiscard]] std::vector<double> point(std::size_t index) const;

 private:
  Study study_;
  std::vector<Variable> variables_;
};

}  // namespace coilwright::sizing
