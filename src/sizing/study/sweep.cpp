#include "coilwright/sizing/study/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <unordered_set>
#include <utility>

#include "sizing/problem/design_space.hpp"
#include "sizing/problem/point_hash.hpp"
#include "sizing/problem/workers.hpp"
#include "sizing/sampling/random.hpp"

namespace coilwright::sizing {
namespace {

// Designs evaluated together and then passed on together: enough to keep every core busy, since all wait for the last
// few, and some 300 kB.
constexpr std::size_t chunk = 512;

SweptDesign evaluate(const DesignProblem& problem, const SweepOptions& options, std::size_t index) {
  SweptDesign out{
      .index = index, .point = options.points.empty() ? problem.point(index) : options.points[index], .evaluation = {}};
  out.evaluation = options.evaluate ? options.evaluate(index, out.point) : problem.assess(problem.evaluate(out.point));
  return out;
}

// The value of a variable below which a share of its range, or of its values, lies.
double value_at_share(const Variable& variable, double share) {
  const double step = grid_step(variable);
  if (step == 0.0) return nearest_legal(variable, variable.lower + share * (variable.upper - variable.lower));
  const double last = last_grid_index(variable);
  return nearest_legal(variable, variable.lower + std::min(last, std::floor(share * (last + 1.0))) * step);
}

}  // namespace

std::string_view name_of(Sampling sampling) {
  return std::ranges::find(sampling_words, sampling, &std::pair<std::string_view, Sampling>::second)->first;
}

std::vector<std::vector<double>> sampled_points(const DesignProblem& problem, const DesignSample& sample) {
  const std::size_t count = sample.drawn;
  const std::vector<Variable> variables = problem.problem().variables;
  std::vector<std::vector<double>> out(count, std::vector<double>(variables.size()));
  std::mt19937_64 random(sample.seed);
  std::vector<std::size_t> strata(count);
  for (std::size_t i = 0; i < variables.size(); ++i) {
    for (std::size_t k = 0; k < count; ++k) strata[k] = k;
    for (std::size_t k = count; k-- > 1;)
      std::swap(strata[k], strata[static_cast<std::size_t>(uniform(random) * static_cast<double>(k + 1))]);
    for (std::size_t k = 0; k < count; ++k) {
      const double within = uniform(random);
      const double share = sample.sampling == Sampling::random
                               ? within
                               : (static_cast<double>(strata[k]) + within) / static_cast<double>(count);
      out[k][i] = value_at_share(variables[i], share);
    }
  }
  std::unordered_set<std::vector<double>, PointHash> seen;
  std::erase_if(out, [&](const std::vector<double>& point) { return !seen.insert(point).second; });
  return out;
}

std::size_t sweep(const DesignProblem& problem, const SweepOptions& options,
                  const std::function<void(const SweptDesign&)>& take) {
  const IndexRange range =
      options.only.value_or(IndexRange{.end = options.points.empty() ? problem.point_count() : options.points.size()});
  Workers workers{options.threads};
  std::vector<std::optional<SweptDesign>> designs;
  for (std::size_t first = range.first; first < range.end; first += chunk) {
    designs.assign(std::min(chunk, range.end - first), std::nullopt);
    workers.run(designs.size(), [&](std::size_t i) {
      if (!options.stop.stop_requested()) designs[i] = evaluate(problem, options, first + i);
    });
    for (std::size_t i = 0; i < designs.size(); ++i) {
      if (!designs[i]) return first + i - range.first;
      take(*designs[i]);
    }
  }
  return range.end - range.first;
}

}  // namespace coilwright::sizing
