#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace coilwright::sizing {

/// The kind of values that a variable may take.
enum class VariableKind {
  continuous,  ///< any value between the bounds, or every `step` of them
  integer,     ///< whole numbers, both bounds included
  categorical  ///< unordered levels, coded 0, 1, ..., upper
};

/// A quantity that a search may choose. Its unit is the problem's own: the search uses values relative to the bounds.
struct Variable {
  std::string name;                              ///< unique in its problem, not empty
  VariableKind kind = VariableKind::continuous;  ///< continuous, integer or categorical
  double lower{};                                ///< smallest value; 0 for a categorical
  double upper{};                                ///< largest value, >= lower; equal bounds fix the variable
  /// Spacing of a grid: values are lower + k * step, k = 0, 1, ..., up to `upper`. 0 is no grid for a continuous
  /// variable and a step of 1 for the others. An integer variable may have a whole step > 1.
  double step{};
};

/// Direction in which an objective improves.
enum class Sense { minimise, maximise };

/// A quantity to make small or large. Its unit is the problem's own.
struct Objective {
  std::string name;               ///< unique among the objectives, not empty
  Sense sense = Sense::minimise;  ///< direction in which it improves
};

/// Result of the evaluation of one design: all numbers, or in `failure` the reason why there are none.
struct Evaluation {
  std::vector<double> objectives{};   ///< in the problem's order; a maximised one is not negated
  std::vector<double> constraints{};  ///< in the problem's order; <= 0 is feasible; scaled by the problem to order 1
  std::string failure{};              ///< why the design could not be evaluated; empty if it was
  /// For a failed design its distance from one that can be evaluated, in any measure of order 1; finite, >= 0.
  double infeasibility{};
  /// Further numbers for the tables of the problem; absent where one does not exist. For a design of a study they are
  /// all quantities of its table; empty if it has no performance. The search keeps them and does not use them.
  std::vector<std::optional<double>> quantities{};

  friend bool operator==(const Evaluation&, const Evaluation&) = default;
};

/// An optimisation problem, free of physics: variables as input, objectives and constraints as output.
struct Problem {
  std::vector<Variable> variables;       ///< at least one
  std::vector<Objective> objectives;     ///< one for `search`, two or three for `pareto`
  std::vector<std::string> constraints;  ///< names of the constraints; may be empty
  /// Evaluates one design. Called from several threads at once; must be pure (same point, same bits). An exception
  /// reaches the caller of `search` or `pareto` after every running evaluation has ended.
  std::function<Evaluation(std::span<const double>)> evaluate;
  /// Evaluates several designs in one call, one after the other, with the bits of `evaluate`: for functions that are
  /// expensive to call and cheap to repeat, such as those of an interpreter. Called on one thread, with the designs
  /// that a search evaluates next; those of an NLopt algorithm come one by one through `evaluate`. Empty: `evaluate`
  /// does all.
  std::function<std::vector<Evaluation>(std::span<const std::vector<double>>)> evaluate_together{};
  /// Designs that a search evaluates first, in this order, a value for each variable. Each becomes its nearest legal
  /// point, within the bounds and on the grid. Those beyond the budget are not evaluated. Empty: none.
  std::vector<std::vector<double>> starts{};
  /// Whether a design breaks a constraint by what is known before it is evaluated; a search then leaves it out. Pure,
  /// much cheaper than `evaluate`, called from several threads at once; never true for a design that `evaluate` finds
  /// feasible. Empty: nothing is known.
  std::function<bool(std::span<const double>)> excluded{};
};

/// Throws std::invalid_argument naming the field, the rule and the value received, unless `problem` can be searched.
void validate_problem(const Problem& problem);

/// Calls `problem.evaluate` and makes the result safe to search on: a number that is not finite becomes a failure with
/// the name of the quantity; a failed design has a finite `infeasibility` and no numbers. Throws std::logic_error if
/// the problem returns another number of objectives or constraints than it declares.
[[nodiscard]] Evaluation evaluate_checked(const Problem& problem, std::span<const double> point);

/// Applies the same checks to an existing evaluation.
[[nodiscard]] Evaluation checked(const Problem& problem, Evaluation evaluation);

/// Sum of the positive constraints (dimensionless, >= 0); for a failed design its `infeasibility`.
[[nodiscard]] double violation(const Evaluation& evaluation);

/// Whether the design was evaluated and no constraint is above 0.
[[nodiscard]] bool is_feasible(const Evaluation& evaluation);

/// Names of the constraints above 0, worst first; for a failed design the reason of its failure.
[[nodiscard]] std::vector<std::string> violated_by(const Problem& problem, const Evaluation& evaluation);

}  // namespace coilwright::sizing
