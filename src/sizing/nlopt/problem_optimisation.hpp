#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <stop_token>
#include <vector>

#include "sizing/nlopt/goal_program.hpp"
#include "sizing/sampling/samples.hpp"
#include "sizing/sampling/unit_point.hpp"

namespace coilwright::sizing {

/// Runs of NLopt on the problem itself, inside one combination of levels.
struct ProblemOptimisation {
  Algorithm algorithm{};             ///< any but `automatic`
  Goal goal;                         ///< what to minimise
  UnitPoint start;                   ///< first start; later ones are drawn from the box while the budget lasts
  Box box;                           ///< where to search
  std::size_t budget{};              ///< largest number of designs that the samples do not know
  std::uint64_t seed{};              ///< of NLopt and of the later starts
  std::vector<Eigen::Index> axes{};  ///< axes to move; empty: all
};

/// Evaluates into `archive` and returns the designs that `samples` did not know, in the order of first request,
/// whatever other optimisations run at the same time. Points are moved to the grid before they are evaluated; gradients
/// are one-sided differences (1e-6 of the range, or one grid step) whose evaluations count. On a request to stop it
/// returns what it has. Throws what the problem throws.
[[nodiscard]] std::vector<Record> optimise_on_problem(Archive& archive, const Samples& samples,
                                                      const ProblemOptimisation& optimisation,
                                                      const std::stop_token& stop);

}  // namespace coilwright::sizing
