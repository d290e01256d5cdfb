#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "coilwright/sizing/problem/archive.hpp"
#include "coilwright/sizing/problem/options.hpp"
#include "coilwright/sizing/search/sensitivity.hpp"

namespace coilwright::sizing {

/// Answer of a search with one objective.
struct SearchResult {
  /// The best feasible design, or, if `feasible` is false, the least infeasible one. One that was evaluated; nothing
  /// was evaluated only if the search was interrupted before its first evaluation.
  std::optional<Record> best{};
  bool feasible{};                        ///< whether `best` meets every constraint
  StopReason stop_reason{};               ///< why the search ended
  std::size_t search_evaluations{};       ///< made by the search; at most max_evaluations
  std::size_t sensitivity_evaluations{};  ///< made afterwards for `sensitivity`, beyond max_evaluations
  /// With nothing feasible: constraints `best` violates or, if it failed, its reason; worst first.
  std::vector<std::string> violated{};
  Sensitivity sensitivity{};  ///< around `best`; empty if nothing is feasible or the search was interrupted
  Archive archive;            ///< every design evaluated
};

/// Finds the best feasible design of a problem with one objective. Deterministic: same problem, options and any number
/// of threads give the same archive. Categorical variables are enumerated, integers and grids only ever evaluated on
/// their values; the answer is taken from the archive, whatever NLopt returned.
/// Throws std::invalid_argument as `check`, or if the problem has not exactly one objective or max_evaluations is 0;
/// and whatever `problem.evaluate` throws.
[[nodiscard]] SearchResult search(const Problem& problem, const SearchOptions& options);

}  // namespace coilwright::sizing
