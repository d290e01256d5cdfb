// How certain the answer of a study with one objective is: searches it with several seeds and prints each answer, and
// how many are the best of all.
//
// usage: sizing_seeds STUDY.json [SEEDS [EVALUATIONS]]
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <vector>

#include "coilwright/formats/study/study_file.hpp"
#include "coilwright/sizing/search/search.hpp"
#include "coilwright/sizing/study/design_problem.hpp"

int main(int argc, char** argv) {
  using namespace coilwright;
  if (argc < 2) {
    fmt::print(stderr, "usage: sizing_seeds STUDY.json [SEEDS [EVALUATIONS]]\n");
    return 2;
  }
  const std::uint64_t seeds = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 10;
  const sizing::DesignProblem study(formats::read_study(argv[1]));
  const sizing::Problem problem = study.problem();
  sizing::SearchOptions options = study.study().search;
  if (argc > 3) options.max_evaluations = std::strtoull(argv[3], nullptr, 10);
  std::vector<double> minimised;  // infinite where nothing is feasible
  for (options.seed = 1; options.seed <= seeds; ++options.seed) {
    const sizing::SearchResult result = sizing::search(problem, options);
    const bool found = result.feasible;
    minimised.push_back(found ? sizing::minimised(problem, result.best->evaluation)[0] : HUGE_VAL);
    fmt::print("seed {:>2}: {}", options.seed,
               found ? fmt::format("{:.8g}", result.best->evaluation.objectives[0]) : "nothing feasible");
    for (const double value : found ? result.best->point : std::vector<double>{}) fmt::print(" {:g}", value);
    fmt::print("\n");
    std::fflush(stdout);
  }
  const double best = std::ranges::min(minimised);
  const auto reached = std::ranges::count_if(
      minimised, [best](double value) { return value <= best + 1e-9 * std::abs(best) && std::isfinite(value); });
  fmt::print("{} of {} seeds reach the best value, {:.8g}\n", reached, seeds, std::abs(best));
}
