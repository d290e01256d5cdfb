#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace coilwright::sizing {

/// What values a variable may take.
enum class VariableKind {
  continuous,  ///< any value between the bounds, or every `step` of them
  integer,     ///< whole numbers, both bounds included
  categorical  ///< unordered levels, coded 0, 1, ..., upper
};

/// One thing a search may choose. Units are the problem's own: the search only uses values relative to the bounds.
struct Variable {
  std::string name;                              ///< unique in its problem, not empty
  VariableKind kind = VariableKind::continuous;  ///< continuous, integer or categorical
  double lower{};                                ///< smallest value; 0 for a categorical
  double upper{};                                ///< largest value, >= lower; equal bounds fix the variable
  /// Grid: the value is lower + k * step, k = 0, 1, ... as long as it does not exceed `upper`. 0: no grid
  /// (continuous) or 1 (integer, categorical). An integer variable may have a whole step > 1.
  double step{};
};

/// Which way an objective improves.
enum class Sense { minimise, maximise };

/// One quantity to make small or large. Unit: the problem's own.
struct Objective {
  std::string name;               ///< unique among the objectives, not empty
  Sense sense = Sense::minimise;  ///< which way is better
};

/// What is known of one design. Either `failure` is empty and all numbers are there, or it says why they are not.
struct Evaluation {
  std::vector<double> objectives;   ///< in the problem's order and own sense (a maximised one is not negated)
  std::vector<double> constraints;  ///< in the problem's order; <= 0 is feasible; scaled by the problem to order 1
  std::string failure;              ///< empty: evaluated; otherwise why the design could not be evaluated
  /// For a failed design: how far it is from one that can be evaluated; finite, >= 0, growing away from it, order 1.
  double infeasibility{};

  friend bool operator==(const Evaluation&, const Evaluation&) = default;
};

/// A sizing problem as the search sees it: variables in, objectives and constraints out, and nothing of physics.
struct Problem {
  std::vector<Variable> variables;       ///< at least one
  std::vector<Objective> objectives;     ///< one for `search`, two or three for `pareto`
  std::vector<std::string> constraints;  ///< names; may be empty
  /// Evaluates one design. Called from several threads at once; must be pure (same point, same bits).
  /// What it throws reaches the caller of `search` or `pareto` after every running evaluation has ended.
  std::function<Evaluation(std::span<const double>)> evaluate;
};

/// Throws std::invalid_argument naming the field, the rule and the value received, unless `problem` can be searched.
void check(const Problem& problem);

/// Calls `problem.evaluate` and makes the answer safe to search on: a number that is not finite becomes a failure with
/// the name of the quantity; a failed design carries no numbers but a finite `infeasibility`.
/// Throws std::logic_error if the problem returns another number of objectives or constraints than it declares.
[[nodiscard]] Evaluation evaluate_checked(const Problem& problem, std::span<const double> point);

/// Sum of the positive constraints (dimensionless, >= 0); for a failed design its `infeasibility`.
[[nodiscard]] double violation(const Evaluation& evaluation);

/// True if the design was evaluated and no constraint is above 0.
[[nodiscard]] bool is_feasible(const Evaluation& evaluation);

}  // namespace coilwright::sizing
