// Prints, for each published problem with one objective and each algorithm, how far above the best known value the
// search ended: median and worst of several seeds, in per cent. usage: best_problems [EVALUATIONS [SEEDS]]

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "coilwright/sizing/search/search.hpp"
#include "sizing/best_problems.hpp"
#include "sizing/front_problems.hpp"

namespace {

namespace sizing = coilwright::sizing;

// Torque of the gridded winding; the best of all 311 040 designs is known by trying them.
sizing::testing::BestProblem enumerated_winding() {
  sizing::Problem problem = sizing::testing::winding_grid(sizing::testing::GridObjectives::two);
  problem.objectives.resize(1);
  problem.evaluate = [inner = problem.evaluate](std::span<const double> x) {
    sizing::Evaluation evaluation = inner(x);
    if (evaluation.failure.empty()) evaluation.objectives.resize(1);
    return evaluation;
  };
  double best = 0;
  for (const sizing::Objectives& value : sizing::testing::enumerate_feasible(problem)) best = std::max(best, -value[0]);
  return {.name = "winding", .problem = std::move(problem), .best = best};
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t evaluations = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 500;
  const std::uint64_t seeds = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 10;
  auto problems = sizing::testing::best_problems();
  problems.push_back(enumerated_winding());
  fmt::print("{} evaluations, {} seeds; median / worst distance from the best known, %\n{:<12}", evaluations, seeds,
             "");
  for (const auto& problem : problems) fmt::print("{:>22}", problem.name);
  fmt::print("\n");
  for (const sizing::Algorithm algorithm : sizing::algorithms()) {
    fmt::print("{:<12}", sizing::name_of(algorithm));
    for (const auto& problem : problems) {
      std::vector<double> excess;
      for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        const auto result = sizing::search(problem.problem, {.algorithm = algorithm,
                                                             .max_evaluations = evaluations,
                                                             .seed = seed,
                                                             .afterwards = sizing::Afterwards::nothing});
        excess.push_back(result.feasible ? 100 * std::abs(result.best->evaluation.objectives[0] / problem.best - 1)
                                         : std::numeric_limits<double>::infinity());
      }
      std::ranges::sort(excess);
      fmt::print("{:>22}", fmt::format("{:.4g} / {:.4g}", excess[excess.size() / 2], excess.back()));
    }
    fmt::print("\n");
    std::fflush(stdout);
  }
}
