#pragma once

#include "coilwright/sizing/problem/archive.hpp"
#include "coilwright/sizing/problem/options.hpp"

namespace coilwright::sizing {

/// A finished search: every design that it evaluated, and why it ended.
struct SearchRun {
  Archive archive;
  StopReason stop_reason{};
};

/// Evaluates the problem's starts, if it has any, and searches with the algorithm that `options` names. Spaces with no
/// more designs than evaluations allowed are enumerated. Throws std::invalid_argument as `validate_problem` and if
/// `max_evaluations` is 0, and what the problem throws.
[[nodiscard]] SearchRun run_search(const Problem& problem, const SearchOptions& options);

}  // namespace coilwright::sizing
