#include "sizing/search/run_search.hpp"

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <utility>
#include <vector>

#include "sizing/search/nlopt_search.hpp"
#include "sizing/search/surrogate_search.hpp"

namespace coilwright::sizing {
namespace {

// The legal designs that a search starts from, each once.
std::vector<std::vector<double>> first_designs(const Problem& problem, std::size_t most) {
  std::vector<std::vector<double>> first;
  for (const std::vector<double>& start : problem.starts) {
    std::vector<double> legal = nearest_legal_point(problem.variables, start);
    if (first.size() < most && std::ranges::find(first, legal) == first.end()) first.push_back(std::move(legal));
  }
  return first;
}

}  // namespace

SearchRun run_search(const Problem& problem, const SearchOptions& options) {
  if (options.max_evaluations == 0) throw std::invalid_argument("max_evaluations: must be >= 1; got 0");
  Archive archive{problem};
  Workers workers{options.threads};
  Samples samples{problem, std::vector<double>(problem.constraints.size(), 0.0), &archive};
  const DesignSpace& space = samples.space();
  const std::vector<std::vector<double>> first = first_designs(problem, options.max_evaluations);
  for (const Record& record : workers.evaluate(archive, first, options.stop, [](std::size_t) { return "start"; }))
    samples.add(record);
  const SearchContext context{.archive = archive,
                              .samples = samples,
                              .workers = workers,
                              .options = options,
                              .budget = options.max_evaluations - archive.size()};
  const std::uint64_t designs = space.design_count();
  const bool enumerable = space.dimension() == 0 || (designs > 0 && designs <= options.max_evaluations);
  const bool with_models = samples.objective_count() > 1 || options.algorithm == Algorithm::automatic || enumerable;
  const StopReason reason = with_models ? surrogate_search(context) : nlopt_search(context);
  return {.archive = std::move(archive), .stop_reason = reason};
}

}  // namespace coilwright::sizing
