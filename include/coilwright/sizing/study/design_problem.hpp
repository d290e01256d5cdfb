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
  /// Throws std::invalid_argument unless either a variable or `study.current` sets the current, and for an objective or
  /// a limit whose quantity `simulation::validate_quantity` refuses.
  explicit DesignProblem(Study study);
  // Copies only: a moved-from object would be empty.
  DesignProblem(const DesignProblem&) = default;
  DesignProblem& operator=(const DesignProblem&) = default;
  ~DesignProblem() = default;

  [[nodiscard]] const Study& study() const noexcept { return state_->study; }

  /// The problem to pass to search() or pareto(). It holds a copy of this object and so all that it needs. It starts
  /// from the study's own actuator; where the current varies, with the chassis ampacity of the actuator's own wire;
  /// then from the study's starts.
  [[nodiscard]] Problem problem() const;

  /// The design at a point: the study's base with the variables set to it.
  [[nodiscard]] actuator::Design design_at(std::span<const double> point) const;

  /// The numbers beside the design that the study varies, at a point, in SI.
  [[nodiscard]] simulation::Settings settings_at(std::span<const double> point) const;

  /// The design at a point and its performance. Pure.
  [[nodiscard]] DesignResult evaluate(std::span<const double> point) const;

  /// The actuator that the study starts from, at the study's operating point. Where a variable sets the current, it is
  /// driven as well as that variable's range and the study's limits let it: with the current of the best first
  /// objective that keeps all limits or, where none does, the one that is nearest to keeping them.
  [[nodiscard]] DesignResult evaluate_base() const;

  /// All quantities of the study's table, the objectives of a design and its constraints, each -margin /
  /// scale_of(limit), so that <= 0 keeps the limit; or why there are none, also where a quantity that the study asks
  /// for has no value.
  [[nodiscard]] Evaluation assess(const DesignResult& result) const;

  /// The same from the quantities alone, in the order of the study's table; nothing where one that the study asks for
  /// has no value or is not in the table: then only the design can say why, or what it is.
  [[nodiscard]] std::optional<Evaluation> assess(std::vector<std::optional<double>> quantities) const;

  /// Number of points of a study whose variables are all lists, grids or whole numbers. Throws std::invalid_argument
  /// naming a variable that is continuous, or if there are more than max_grid_points.
  [[nodiscard]] std::size_t point_count() const;
  /// Point `index` < point_count() of these, where the last variable changes fastest.
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
