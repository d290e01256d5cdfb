#include "coilwright/sizing/search/search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "sizing/search/run_search.hpp"

namespace coilwright::sizing {
namespace {

// The surroundings of the answer may hold a better design than the search found. Then that one is the answer, with its
// own surroundings. Each repetition improves the answer: three are enough after a search of hundreds of evaluations,
// one of sixty has taken more.
constexpr int max_repetitions = 40;

void add_sensitivity(SearchResult& result, const SearchOptions& options) {
  const std::size_t before = result.archive.size();
  const SensitivityOptions sensitivity{
      .relaxed_evaluations = std::clamp<std::size_t>(options.max_evaluations / 10, 40, 200), .search = options};
  for (int repetition = 0; repetition < max_repetitions && !options.stop.stop_requested(); ++repetition) {
    result.sensitivity = analyse_sensitivity(result.archive, *result.best, sensitivity);
    const std::optional<Record> better = result.archive.best_feasible();
    if (better->point == result.best->point) break;
    result.best = better;
    result.sensitivity = {};  // of the design before
  }
  result.sensitivity_evaluations = result.archive.size() - before;
}

}  // namespace

SearchResult search(const Problem& problem, const SearchOptions& options) {
  validate_problem(problem);
  if (problem.objectives.size() != 1) {
    throw std::invalid_argument(fmt::format("objectives: must be one for a search (pareto takes two or three); got {}",
                                            problem.objectives.size()));
  }
  SearchRun run = run_search(problem, options);
  SearchResult result{
      .stop_reason = run.stop_reason, .search_stop_reason = run.stop_reason, .archive = std::move(run.archive)};
  result.search_evaluations = result.archive.size();
  result.best = result.archive.best_feasible();
  result.feasible = result.best.has_value();
  if (!result.feasible) {
    result.best = result.archive.least_infeasible();
    if (result.best) result.violated = violated_by(problem, result.best->evaluation);
  } else if (options.afterwards == Afterwards::sensitivity) {
    add_sensitivity(result, options);
    if (options.stop.stop_requested()) result.stop_reason = StopReason::interrupted;
  }
  return result;
}

}  // namespace coilwright::sizing
