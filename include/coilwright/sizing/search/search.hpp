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
  /// The best feasible design or, if `feasible` is false, the least infeasible one. Empty only if the search was
  /// interrupted before its first evaluation.
  std::optional<Record> best{};
  bool feasible{};                        ///< whether `best` meets every constraint
  StopReason stop_reason{};               ///< why the search ended; interrupted if the steps after it were
  StopReason search_stop_reason{};        ///< why the search itself ended
  std::size_t search_evaluations{};       ///< number of designs that the search evaluated, at most max_evaluations
  std::size_t sensitivity_evaluations{};  ///< number evaluated afterwards for `sensitivity`, beyond max_evaluations
  /// If nothing is feasible: the constraints that `best` violates, worst first, or why it could not be evaluated.
  std::vector<std::string> violated{};
  Sensitivity sensitivity{};  ///< of `best`; empty if nothing is feasible or the search was interrupted
  Archive archive;            ///< every design evaluated
};

/// Finds the best feasible design of a problem with one objective. Deterministic: the same problem and options give the
/// same archive on any number of threads. Integer variables and grids are evaluated at their own values only. The
/// answer is taken from the archive, not from NLopt. Throws std::invalid_argument as `validate_problem`, or if the
/// problem has not exactly one objective or max_evaluations is 0; passes on exceptions of `problem.evaluate`.
[[nodiscard]] SearchResult search(const Problem& problem, const SearchOptions& options);

}  // namespace coilwright::sizing
