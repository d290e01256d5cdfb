#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "coilwright/simulation/evaluate.hpp"
#include "coilwright/sizing/study/study.hpp"

namespace coilwright::sizing {

/// A study's design at one point of its search space, with its performance.
using simulation::EvaluatedDesign;

/// Why a study's design cannot be evaluated.
struct NotEvaluated {
  std::string reason;      ///< one line
  double infeasibility{};  ///< `Evaluation::infeasibility`, > 0
};

using DesignResult = std::variant<EvaluatedDesign, NotEvaluated>;

/// A study as an optimisation problem. Immutable; copies are cheap and share the study. A point has one coordinate for
/// each variable of the study, in the unit of the variable's name; for lists and layouts it is the index of the
/// value.
class DesignProblem {
 public:
  /// Makes the problem. Throws std::invalid_argument unless either a variable or `study.current` sets the current, and
  /// for an objective or a limit whose quantity `simulation::validate_quantity` refuses.
  explicit DesignProblem(Study study);
  // Copies only: a moved-from object would be empty.
  DesignProblem(const DesignProblem&) = default;
  DesignProblem& operator=(const DesignProblem&) = default;
  ~DesignProblem() = default;

  [[nodiscard]] const Study& study() const noexcept { return state_->study; }

  /// The problem for search() or pareto(), which holds a copy of this object. It starts from the study's own actuator
  /// (if the current varies, with the chassis ampacity of its wire), then from the study's starts.
  [[nodiscard]] Problem problem() const;

  /// The design at a point: the study's base with the variables set to it.
  [[nodiscard]] actuator::Design design_at(std::span<const double> point) const;

  /// The values of the study's variables outside the design at a point, in SI.
  [[nodiscard]] simulation::Settings settings_at(std::span<const double> point) const;

  /// The design at a point and its performance. Pure.
  [[nodiscard]] DesignResult evaluate(std::span<const double> point) const;

  /// The actuator from which the study starts, at the study's operating point. If a variable sets the current, it is
  /// driven as well as that variable's range and the study's limits allow: with the current of the best first objective
  /// that keeps all limits, or else the current that is nearest to keeping them.
  [[nodiscard]] DesignResult evaluate_base() const;

  /// All quantities of the study's table, the objectives of a design and its constraints, each -margin /
  /// scale_of(limit), so that <= 0 keeps the limit; or the reason why there are none, such as a requested quantity
  /// without a value.
  [[nodiscard]] Evaluation assess(const DesignResult& result) const;

  /// The same from the quantities alone, in the order of the study's table. Absent if a requested quantity has no value
  /// or is not in the table, because only the design can then give it or the reason.
  [[nodiscard]] std::optional<Evaluation> assess(std::vector<std::optional<double>> quantities) const;

  /// Number of points of a study whose variables are all lists, grids or whole numbers. Throws std::invalid_argument
  /// naming a variable that is continuous, or if there are more than max_grid_points.
  [[nodiscard]] std::size_t point_count() const;
  /// Point `index` < point_count() of these; the last variable changes fastest.
  [[nodiscard]] std::vector<double> point(std::size_t index) const;

  /// The largest grid that point_count() accepts.
  static constexpr std::size_t max_grid_points = 1'000'000'000'000;

 private:
  struct State {
    Study study;
    std::vector<Variable> variables;
  };
  std::shared_ptr<const State> state_;  // shared: problems and archives carry copies
};

}  // namespace coilwright::sizing
