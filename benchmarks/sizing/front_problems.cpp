// Prints, for each published problem, the hypervolume reached over the true front's: worst and median of several seeds.
// usage: front_problems DATA_FILE [SEEDS [ALGORITHM [PROBLEM]]]

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>

#include "coilwright/sizing/search/pareto.hpp"
#include "sizing/front_problems.hpp"

namespace {

namespace sizing = coilwright::sizing;
using sizing::testing::FrontProblem;

FrontProblem enumerated_grid(const char* name, sizing::testing::GridObjectives objectives) {
  sizing::Problem problem = sizing::testing::winding_grid(objectives);
  const std::vector<sizing::Objectives> all = sizing::testing::enumerate_feasible(problem);
  const sizing::FrontFrame frame = sizing::frame_of(all);
  std::vector<sizing::Objectives> front;
  for (const std::size_t i : sizing::non_dominated(all)) front.push_back(all[i]);
  return {.name = name,
          .problem = std::move(problem),
          .budget = 3110,  // 1 % of the designs
          .target = 0.995,
          .frame = frame,
          .hypervolume = sizing::normalised_hypervolume(front, frame)};
}

void run(const FrontProblem& front_problem, std::uint64_t seeds, sizing::Algorithm algorithm) {
  std::vector<double> ratios;
  std::size_t most = 0;
  const auto start = std::chrono::steady_clock::now();
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const sizing::ParetoResult result = sizing::pareto(
        front_problem.problem, {.algorithm = algorithm, .max_evaluations = front_problem.budget, .seed = seed});
    most = std::max(most, result.evaluations);
    ratios.push_back(hypervolume_ratio(front_problem, minimised(front_problem.problem, result.front)));
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::ranges::sort(ratios);
  fmt::print("{:<12} {:>6} {:>6} {:>8.5f} {:>8.5f} {:>7.3f} {:>5} {:>8.3f}\n", front_problem.name, front_problem.budget,
             most, ratios.front(), ratios[ratios.size() / 2], front_problem.target,
             ratios.front() >= front_problem.target ? "yes" : "no", 1e3 * seconds / static_cast<double>(seeds * most));
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    fmt::print(stderr, "usage: {} tests/data/sizing/front_problems.csv [SEEDS [ALGORITHM [PROBLEM]]]\n", argv[0]);
    return 2;
  }
  const std::uint64_t seeds = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 10;
  const sizing::Algorithm algorithm = sizing::algorithm_named(argc > 3 ? argv[3] : "automatic");
  const std::string only = argc > 4 ? argv[4] : "";
  fmt::print("{:<12} {:>6} {:>6} {:>8} {:>8} {:>7} {:>5} {:>8}\n", "problem", "budget", "used", "worst", "median",
             "target", "all", "ms/eval");
  std::vector<FrontProblem> problems = sizing::testing::front_problems(argv[1]);
  if (only.empty() || only == "GRID2") {
    problems.push_back(enumerated_grid("GRID2", sizing::testing::GridObjectives::two));
  }
  if (only.empty() || only == "GRID3") {
    problems.push_back(enumerated_grid("GRID3", sizing::testing::GridObjectives::three));
  }
  for (const FrontProblem& problem : problems) {
    if (only.empty() || only == problem.name) run(problem, seeds, algorithm);
  }
}
