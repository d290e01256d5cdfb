#pragma once

#include <Eigen/Core>
#include <functional>
#include <span>
#include <vector>

#include "sizing/nlopt/nlopt_run.hpp"
#include "sizing/sampling/goal.hpp"
#include "sizing/surrogate/surrogate.hpp"

namespace coilwright::sizing {

/// Part of the unit cube.
struct Box {
  Eigen::VectorXd lower, upper;
};

/// Objectives, then constraints, as functions of unit coordinates: a model of them, or the problem itself.
struct Field {
  /// What a call asks for.
  enum class Wanted { values, slopes };
  std::function<Surrogate::Linearisation(const Eigen::VectorXd& x, Wanted wanted)> at;  ///< jacobian only for `slopes`
  Eigen::Index objectives{}, constraints{};                                             ///< number of each
  double margin{};  ///< constraints are asked to hold with this to spare
};

/// How NLopt is to go about it.
struct Descent {
  Algorithm algorithm{};
  int max_calls{};
  double relative_tolerance{};
  double first_step{};  ///< over the box; 0: NLopt's own
  std::uint64_t seed = 1;
};

/// Minimises a goal over the free axes of a box with NLopt, starting at `start`, and returns where NLopt ended. A
/// min-max goal is posed smoothly to algorithms that take constraints: its value becomes a variable, its terms
/// constraints.
[[nodiscard]] Eigen::VectorXd minimise(const Field& field, const Goal& goal, const Box& box,
                                       const Eigen::VectorXd& start, const std::vector<Eigen::Index>& free,
                                       const Descent& descent);

}  // namespace coilwright::sizing
