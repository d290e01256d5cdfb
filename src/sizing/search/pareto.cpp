#include "coilwright/sizing/search/pareto.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "sizing/search/run_search.hpp"

namespace coilwright::sizing {

ParetoResult pareto(const Problem& problem, const ParetoOptions& options) {
  validate_problem(problem);
  if (problem.objectives.size() < 2 || problem.objectives.size() > 3) {
    throw std::invalid_argument(
        fmt::format("objectives: must be two or three for a front; got {}", problem.objectives.size()));
  }
  SearchRun run = run_search(problem, options);
  ParetoResult result{.stop_reason = run.stop_reason, .archive = std::move(run.archive)};
  result.front = result.archive.front();
  result.evaluations = result.archive.size();
  if (result.front.empty()) {
    result.least_infeasible = result.archive.least_infeasible();
    if (result.least_infeasible) result.violated = violated_by(problem, result.least_infeasible->evaluation);
  }
  return result;
}

}  // namespace coilwright::sizing
