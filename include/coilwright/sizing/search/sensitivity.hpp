#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "coilwright/sizing/problem/archive.hpp"
#include "coilwright/sizing/problem/options.hpp"

namespace coilwright::sizing {

/// One step of one variable away from the best design.
struct VariableStep {
  std::string variable;                    ///< its name
  double from{};                           ///< value at the best design
  double to{};                             ///< value after the step
  std::optional<double> objective_change;  ///< objective after minus before, its own sense; none if it failed
  bool improves{};                         ///< the objective is better after the step
  std::vector<std::string> violates;       ///< constraints above 0 after the step, or the failure's reason
};

/// A constraint that stands in the way at the best design, and what it costs.
struct BindingConstraint {
  std::string name;                        ///< of the constraint
  double margin{};                         ///< -value at the best design, >= 0
  bool at_limit{};                         ///< margin below `binding_margin`
  bool blocks_step{};                      ///< an improving step of one variable violates it
  double relaxed_by{};                     ///< the constraint was allowed up to this value in the search again
  std::optional<double> objective_change;  ///< gain of that search: objective after minus before, its own sense
  std::optional<Record> relaxed_best;      ///< the design that search found; none if it found nothing better
};

/// How the best design sits in its surroundings.
struct Sensitivity {
  std::vector<VariableStep> steps{};         ///< one down, one up for each variable where the bounds allow; all levels
  std::vector<BindingConstraint> binding{};  ///< at the limit, or blocking an improving step
};

/// Margin below which a constraint counts as at its limit: one part in a thousand of its scale.
inline constexpr double binding_margin = 1e-3;

/// Options of `sensitivity_of`.
struct SensitivityOptions {
  double relative_step = 0.01;            ///< step of an ungridded variable over its range; > 0, <= 1
  double relaxation = 0.05;               ///< a constraint's new limit, in its scale; > 0
  std::size_t relaxed_evaluations = 200;  ///< new designs at most for each relaxed constraint
  SearchOptions search{};                 ///< seed, threads, stop of the searches with a relaxed constraint
};

/// Steps each variable once down and once up from `best` (every other level of a categorical), then searches again from
/// there with each binding constraint relaxed: once with the models of `Algorithm::automatic`, warm with everything in
/// `archive`, to which all designs are added. A lower bound of the true gain: the search may miss some of it.
/// Throws std::invalid_argument for an option out of range or a `best` that is not in the archive or not feasible.
[[nodiscard]] Sensitivity sensitivity_of(Archive& archive, const Record& best, const SensitivityOptions& options);

}  // namespace coilwright::sizing
