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
  std::optional<Record> least_infeasible{};  ///< if the front is empty and any design was evaluated
  std::vector<std::string> violated{};       ///< constraints that it violates, worst first, or its failure
  StopReason stop_reason{};                  ///< why the search ended
  std::size_t evaluations{};                 ///< number of designs evaluated, at most max_evaluations
  Archive archive;                           ///< every design evaluated
};

/// Finds designs that trade two or three objectives against each other, spread so that their hypervolume is large.
/// Deterministic and recorded as in `search`. Throws as `search`, and for a problem without two or three objectives.
[[nodiscard]] ParetoResult pareto(const Problem& problem, const ParetoOptions& options);

}  // namespace coilwright::sizing
