#pragma once

#include <cstddef>
#include <cstdint>
#include <stop_token>
#include <vector>

#include "sizing/nlopt/goal_program.hpp"
#include "sizing/search/surrogate_search.hpp"
#include "sizing/surrogate/infill.hpp"

namespace coilwright::sizing {

/// One NLopt run on the problem itself, inside one combination of levels.
struct DirectTask {
  Algorithm algorithm{};             ///< not `automatic`
  Goal goal;                         ///< what to minimise
  Candidate start;                   ///< where; local algorithms start again elsewhere in the box while budget is left
  Box box;                           ///< part of the unit cube
  std::size_t budget{};              ///< designs not known to the samples at most
  std::uint64_t seed{};              ///< of NLopt and of the further starts
  std::vector<Eigen::Index> axes{};  ///< moved; empty: all
};

/// Runs the task. Every design is asked of `archive`; those `samples` did not know are returned in the order of first
/// request, whatever other tasks run at the same time. Points are moved to the grid before they are evaluated;
/// gradients are one-sided differences (1e-6 of the range, or one grid step), counted like any evaluation. Ends early,
/// with what it has, on a request to stop. Throws what the problem throws.
[[nodiscard]] std::vector<Record> run_direct(Archive& archive, const Samples& samples, const DirectTask& task,
                                             const std::stop_token& stop);

/// Search for the best design with a named NLopt algorithm: scattered starts, then one run for each combination of
/// levels, in rounds that keep the better half (successive halving, the same budget each round), then the integer
/// neighbourhood of the best.
[[nodiscard]] StopReason search_directly(const EngineRun& run);

}  // namespace coilwright::sizing
