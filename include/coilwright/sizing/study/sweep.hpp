#pragma once

#include <cstddef>
#include <functional>
#include <stop_token>
#include <vector>

#include "coilwright/sizing/study/design_problem.hpp"

namespace coilwright::sizing {

/// One design of a sweep.
struct SweptDesign {
  std::size_t index{};        ///< as in DesignProblem::point
  std::vector<double> point;  ///< coordinates
  Evaluation evaluation;      ///< quantities, objectives and constraints, or the reason why there are none
};

/// How a sweep runs. The result does not depend on it.
struct SweepOptions {
  unsigned threads = 0;    ///< designs evaluated at the same time; 0: one per core
  std::stop_token stop{};  ///< ends the sweep early
  /// Evaluates the point of that index, with the bits of the problem's own evaluation, say from what is recorded;
  /// called from several threads at once. Empty: the problem's own.
  std::function<Evaluation(std::size_t index, std::span<const double> point)> evaluate{};
};

/// Evaluates every point of a problem's grid, several at the same time, and passes each to `take` in the order of the
/// points, on the caller's thread. The memory needed is that of some hundred designs, for any size of the grid. Returns
/// the number of designs passed, which is below point_count() only after a request to stop; they are then the first
/// ones of the grid, without a gap. Throws as DesignProblem::point_count, and what `take` throws.
std::size_t sweep(const DesignProblem& problem, const SweepOptions& options,
                  const std::function<void(const SweptDesign&)>& take);

}  // namespace coilwright::sizing
