#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

#include "coilwright/sizing/study/design_problem.hpp"

namespace coilwright::sizing {

/// One design of a sweep.
struct SweptDesign {
  std::size_t index{};        ///< of DesignProblem::point
  std::vector<double> point;  ///< coordinates
  Evaluation evaluation;      ///< objectives and constraints, or why there are none
  /// In the order of the study's table, nothing where one has no value. Empty for a design that has no performance.
  std::vector<std::optional<double>> quantities;
};

/// How a sweep runs; what it gives does not depend on it.
struct SweepOptions {
  unsigned threads = 0;    ///< evaluations at once; 0: one per core
  std::stop_token stop{};  ///< asks for an early end
};

/// Evaluates every point of a problem's grid, several at once, and hands each to `take` in the order of the points, on
/// the caller's thread. Memory is that of some hundred designs, however large the grid. Returns how many were taken:
/// fewer than point_count() only after a request to stop, and then the first ones without a gap.
/// Throws as DesignProblem::point_count, and what `take` throws.
std::size_t sweep(const DesignProblem& problem, const SweepOptions& options,
                  const std::function<void(const SweptDesign&)>& take);

}  // namespace coilwright::sizing
