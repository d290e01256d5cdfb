#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "coilwright/sizing/problem/archive.hpp"
#include "coilwright/sizing/problem/options.hpp"

namespace coilwright::sizing {

/// The effect of one step of one variable away from the best design.
struct VariableStep {
  std::string variable;                    ///< name of the variable
  double from{};                           ///< value at the best design
  double to{};                             ///< value after the step
  std::optional<double> objective_change;  ///< objective after the step minus before; none if the design failed
  bool improves{};                         ///< the objective is better after the step
  std::vector<std::string> violates;       ///< constraints above 0 after the step, or the reason of the failure
};

/// A constraint that keeps the best design from improving, and its cost.
struct BindingConstraint {
  std::string name;                        ///< name of the constraint
  double margin{};                         ///< -value at the best design, >= 0
  bool at_limit{};                         ///< margin below `binding_margin`
  bool blocks_step{};                      ///< an improving step of one variable violates it
  double relaxed_by{};                     ///< largest value of the constraint in the search that relaxes it
  std::optional<double> objective_change;  ///< change in that search: objective after minus before
  std::optional<Record> relaxed_best;      ///< the design of that search; none if it found nothing better
};

/// The steps and the binding constraints around the best design.
struct Sensitivity {
  std::vector<VariableStep> steps{};  ///< one step down and one up of each variable, if its bounds allow; all levels
  std::vector<BindingConstraint> binding{};  ///< constraints at their limit, or that an improving step violates
};

/// Margin, relative to its scale, below which a constraint is at its limit.
inline constexpr double binding_margin = 1e-3;

/// Options of `analyse_sensitivity`.
struct SensitivityOptions {
  double relative_step = 0.01;            ///< step of a variable without a grid, relative to its range; > 0, <= 1
  double relaxation = 0.05;               ///< new limit of a relaxed constraint, in its scale; > 0
  std::size_t relaxed_evaluations = 200;  ///< largest number of new designs for each relaxed constraint
  SearchOptions search{};                 ///< seed, threads and stop of the searches with a relaxed constraint
};

/// Evaluates one step down and one up of each variable from `best` (every other level of a categorical variable), then
/// continues the search with each binding constraint relaxed in turn, with the models of `Algorithm::automatic` and
/// from all designs in `archive`. The gains are lower bounds, because a search may miss a better design. Every design
/// is recorded in `archive`, on which a later search can build. Throws std::invalid_argument for an option out of range
/// or a `best` that is not in the archive or not feasible.
[[nodiscard]] Sensitivity analyse_sensitivity(Archive& archive, const Record& best, const SensitivityOptions& options);

}  // namespace coilwright::sizing
