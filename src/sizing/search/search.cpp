#include "coilwright/sizing/search/search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "sizing/search/run.hpp"

namespace coilwright::sizing {
namespace {

// The surroundings may hold a better design than the search found: then that one is the answer, with its own
// surroundings. Each turn improves the answer; three are enough to stop improving in all cases seen.
constexpr int moves_allowed = 3;

void add_sensitivity(SearchResult& result, const SearchOptions& options) {
  const std::size_t before = result.archive.size();
  const SensitivityOptions sensitivity{
      .relaxed_evaluations = std::clamp<std::size_t>(options.max_evaluations / 10, 40, 200), .search = options};
  for (int move = 0; move < moves_allowed && !options.stop.stop_requested(); ++move) {
    result.sensitivity = sensitivity_of(result.archive, *result.best, sensitivity);
    const std::optional<Record> better = result.archive.best_feasible();
    if (better->point == result.best->point) break;
    result.best = better;
  }
  result.sensitivity_evaluations = result.archive.size() - before;
}

}  // namespace

SearchResult search(const Problem& problem, const SearchOptions& options) {
  check(problem);
  if (problem.objectives.size() != 1) {
    throw std::invalid_argument(fmt::format("objectives: must be one for a search (pareto takes two or three); got {}",
                                            problem.objectives.size()));
  }
  SearchResult result{.archive = Archive{problem}};
  result.stop_reason = run_search(result.archive, options);
  result.search_evaluations = result.archive.size();
  result.best = result.archive.best_feasible();
  result.feasible = result.best.has_value();
  if (!result.feasible) {
    result.best = result.archive.least_infeasible();
    if (result.best) result.violated = violated_by(problem, result.best->evaluation);
  } else if (options.afterwards == Afterwards::sensitivity) {
    add_sensitivity(result, options);
  }
  return result;
}

}  // namespace coilwright::sizing
