#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "coilwright/sizing/problem/archive.hpp"
#include "coilwright/sizing/problem/options.hpp"

namespace coilwright::sizing {

/// Answer of a search with two or three objectives.
struct ParetoResult {
  std::vector<Record> front{};  ///< feasible, non-dominated, sorted as `Archive::front`; empty if none is feasible
  std::optional<Record> least_infeasible{};  ///< if the front is empty and anything was evaluated
  std::vector<std::string> violated{};       ///< constraints `least_infeasible` violates or its failure, worst first
  StopReason stop_reason{};                  ///< why the search ended
  std::size_t evaluations{};                 ///< made; at most max_evaluations
  Archive archive;                           ///< every design evaluated
};

/// Finds designs that trade two or three objectives against each other, spread so that their hypervolume is large.
/// Deterministic and recorded as `search`. Throws as `search`, for a problem with other than two or three objectives.
[[nodiscard]] ParetoResult pareto(const Problem& problem, const ParetoOptions& options);

}  // namespace coilwright::sizing
