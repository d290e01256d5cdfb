#include "sizing/study/base_current.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <tuple>

#include "sizing/problem/design_space.hpp"

namespace coilwright::sizing {
namespace {

constexpr int ladder = 16;               // intervals between two ends
constexpr double finest = 1.0 / 1000.0;  // of the range, where it has no steps

// The less the better: what keeps the limits, then what can be evaluated, then how well. Where a limit is broken at any
// current (mass), the objective decides among those that break no other one.
using Rank = std::tuple<int, double, double>;

Rank rank_of(const Evaluation& seen, const StudyObjective& objective) {
  if (!seen.failure.empty()) return {2, seen.infeasibility, 0.0};
  const double value = seen.objectives.front();
  return {is_feasible(seen) ? 0 : 1, violation(seen), objective.sense == Sense::maximise ? -value : value};
}

}  // namespace

double best_current(const CurrentVariable& variable, const StudyObjective& objective,
                    const std::function<Evaluation(double)>& assess) {
  const StudyVariable studied = variable;
  const Variable range = search_variable(studied);
  std::map<double, Rank> ranks;  // by coordinate
  const auto look = [&](double coordinate) {
    const double legal = nearest_legal(range, coordinate);
    if (!ranks.contains(legal))
      ranks.emplace(legal, rank_of(assess(std::get<double>(value_at(studied, legal))), objective));
  };
  const auto best = [&] { return std::ranges::min_element(ranks, {}, [](const auto& each) { return each.second; }); };
  double lower = range.lower, upper = range.upper;
  for (double width = upper - lower;; width = upper - lower) {
    const std::size_t known = ranks.size();
    for (int i = 0; i <= ladder; ++i) look(lower + width * i / ladder);
    const auto found = best();
    lower = found == ranks.begin() ? found->first : std::prev(found)->first;
    upper = std::next(found) == ranks.end() ? found->first : std::next(found)->first;
    // On a grid nothing new is left at last; without one, what is found is fine enough.
    if (ranks.size() == known || width < finest * (range.upper - range.lower))
      return std::get<double>(value_at(studied, found->first));
  }
}

}  // namespace coilwright::sizing
