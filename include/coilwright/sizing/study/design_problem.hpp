#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "coilwright/sizing/study/study.hpp"

namespace coilwright::sizing {

/// A study's design at one point of its search space, with what it does; or why it cannot be evaluated.
struct EvaluatedDesign {
  actuator::Design design;
  actuator::Assembly assembly;
  simulation::OperatingPoint point;
  simulation::Performance performance;

  [[nodiscard]] simulation::DesignView view() const {
    return {.design = design, .assembly = assembly, .point = point, .performance = performance};
  }
};
struct NotEvaluated {
  std::string reason;
  double infeasibility{};  ///< grows away from what can be evaluated, > 0
};

using DesignResult = std::variant<EvaluatedDesign, NotEvaluated>;

/// A study as the search sees it. Immutable; copies are cheap and share the study. Points of the search hold a value
/// per study variable in the unit of its name, but for lists and configurations, whose coordinate is the index of the
/// value.
class DesignProblem {
 public:
  /// Throws std::invalid_argument unless either a variable or `study.current` sets the current, and for an objective or
  /// a limit whose quantity `simulation::validate_quantity` refuses.
  explicit DesignProblem(Study study);
  // Copies only: a moved-from object would be empty.
  DesignProblem(const DesignProblem&) = default;
  DesignProblem& operator=(const DesignProblem&) = default;
  ~DesignProblem() = default;

  [[nodiscard]] const Study& study() const noexcept { return state_->study; }

  /// The problem to hand to search() or pareto(). It holds a copy of this object, and hence all that it needs.
  [[nodiscard]] Problem problem() const;

  /// The design at a point: the study's base with the variables set.
  [[nodiscard]] actuator::Design design_at(std::span<const double> point) const;

  /// Everything about a point. Pure.
  [[nodiscard]] DesignResult evaluate(std::span<const double> point) const;

  /// The actuator that the study starts from, at the study's operating point. Where a variable sets the current there
  /// is no such point.
  [[nodiscard]] DesignResult evaluate_base() const;

  /// What the search is told of a design: its objectives and its constraints, each -margin / scale_of(limit), so <= 0
  /// is kept; or, also where a quantity it asks for has no value, why not.
  [[nodiscard]] Evaluation assess(const DesignResult& result) const;

  /// All points of a study whose variables are all lists, grids or whole numbers, one by one: point `index` of
  /// point_count(), the last variable fastest. Throws std::invalid_argument naming a variable that is continuous, or
  /// when there are more than most_points.
  [[nodiscard]] std::size_t point_count() const;
  [[nodiscard]] std::vector<double> point(std::size_t index) const;

  static constexpr std::size_t most_points = 1'000'000'000'000;

 private:
  struct State {
    Study study;
    std::vector<Variable> variables;
  };
  std::shared_ptr<const State> state_;  // shared: problems and archives carry copies
};

}  // namespace coilwright::sizing
