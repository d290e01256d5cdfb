#include "coilwright/sizing/study/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sizing/problem/workers.hpp"

namespace coilwright::sizing {
namespace {

// Designs evaluated together and then passed on together: enough to keep every core busy, since all wait for the last
// few, and some 300 kB.
constexpr std::size_t chunk = 512;

SweptDesign evaluate(const DesignProblem& problem, const SweepOptions& options, std::size_t index) {
  SweptDesign out{.index = index, .point = problem.point(index), .evaluation = {}};
  out.evaluation = options.evaluate ? options.evaluate(index, out.point) : problem.assess(problem.evaluate(out.point));
  return out;
}

}  // namespace

std::size_t sweep(const DesignProblem& problem, const SweepOptions& options,
                  const std::function<void(const SweptDesign&)>& take) {
  const std::size_t count = problem.point_count();
  Workers workers{options.threads};
  std::vector<std::optional<SweptDesign>> designs;
  for (std::size_t first = 0; first < count; first += chunk) {
    designs.assign(std::min(chunk, count - first), std::nullopt);
    workers.run(designs.size(), [&](std::size_t i) {
      if (!options.stop.stop_requested()) designs[i] = evaluate(problem, options, first + i);
    });
    for (std::size_t i = 0; i < designs.size(); ++i) {
      if (!designs[i]) return first + i;
      take(*designs[i]);
    }
  }
  return count;
}

}  // namespace coilwright::sizing
