#include "sizing/search/run.hpp"

#include <algorithm>
#include <stdexcept>

#include "sizing/search/nlopt_search.hpp"
#include "sizing/search/surrogate_search.hpp"

namespace coilwright::sizing {

StopReason run_search(Archive& archive, const SearchOptions& options) {
  if (options.max_evaluations == 0) throw std::invalid_argument("max_evaluations: must be >= 1; got 0");
  Workers workers{options.threads};
  Samples samples{archive.problem(), std::vector<double>(archive.problem().constraints.size(), 0.0)};
  const EngineRun run{.archive = archive,
                      .samples = samples,
                      .workers = workers,
                      .options = options,
                      .budget = options.max_evaluations};
  const std::uint64_t designs = samples.space().design_count();
  const bool enumerable = samples.space().dimension() == 0 || (designs > 0 && designs <= options.max_evaluations);
  if (samples.objective_count() > 1 || options.algorithm == Algorithm::automatic || enumerable) return run_engine(run);
  return search_directly(run);
}

std::vector<std::string> violated_by(const Problem& problem, const Evaluation& evaluation) {
  if (!evaluation.failure.empty()) return {evaluation.failure};
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < evaluation.constraints.size(); ++i) {
    if (evaluation.constraints[i] > 0) order.emplace_back(-evaluation.constraints[i], i);
  }
  std::ranges::sort(order);
  std::vector<std::string> names;
  for (const auto& entry : order) names.push_back(problem.constraints[entry.second]);
  return names;
}

}  // namespace coilwright::sizing
