// How certain the answer of a study is: searches it with several seeds. Of one objective it prints each answer, and how
// many are the best of all; of a front, by how much each end is behind what a search for that objective alone finds
// with as many evaluations (the median of the same seeds), under the same limits and in the same poses.
//
// usage: sizing_seeds STUDY.json [SEEDS [EVALUATIONS]]
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <utility>
#include <vector>

#include "coilwright/formats/study/study_file.hpp"
#include "coilwright/sizing/search/pareto.hpp"
#include "coilwright/sizing/search/search.hpp"
#include "coilwright/sizing/study/design_problem.hpp"

namespace {

using namespace coilwright;

double best_alone(sizing::Study study, std::size_t objective, sizing::SearchOptions options, std::uint64_t seeds) {
  study.objectives = {study.objectives[objective]};
  const sizing::Problem problem = sizing::DesignProblem(std::move(study)).problem();
  options.afterwards = sizing::Afterwards::nothing;
  std::vector<double> found;
  for (options.seed = 1; options.seed <= seeds; ++options.seed) {
    const sizing::SearchResult result = sizing::search(problem, options);
    found.push_back(result.feasible ? sizing::minimised(problem, result.best->evaluation)[0] : HUGE_VAL);
  }
  std::ranges::sort(found);
  return found[found.size() / 2];
}

void print_ends(const sizing::Study& study, sizing::SearchOptions options, std::uint64_t seeds) {
  std::vector<double> alone;
  for (std::size_t k = 0; k < study.objectives.size(); ++k) alone.push_back(best_alone(study, k, options, seeds));
  const sizing::Problem problem = sizing::DesignProblem(study).problem();
  std::vector<std::vector<double>> behind(alone.size());
  for (options.seed = 1; options.seed <= seeds; ++options.seed) {
    const sizing::ParetoResult result = sizing::pareto(problem, options);
    fmt::print("seed {:>2}: {} designs on the front", options.seed, result.front.size());
    for (std::size_t k = 0; k < alone.size(); ++k) {
      double best = HUGE_VAL;
      for (const sizing::Objectives& values : minimised(problem, result.front)) best = std::min(best, values[k]);
      behind[k].push_back(100.0 * (best - alone[k]) / std::abs(alone[k]));
      fmt::print(", {} {:.6g} ({:.1f} % behind {:.6g})", problem.objectives[k].name, std::abs(best), behind[k].back(),
                 std::abs(alone[k]));
    }
    fmt::print("\n");
    std::fflush(stdout);
  }
  for (std::size_t k = 0; k < alone.size(); ++k) {
    std::ranges::sort(behind[k]);
    fmt::print("{}: median {:.1f} %, worst {:.1f} % behind\n", problem.objectives[k].name,
               behind[k][behind[k].size() / 2], behind[k].back());
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    fmt::print(stderr, "usage: sizing_seeds STUDY.json [SEEDS [EVALUATIONS]]\n");
    return 2;
  }
  const std::uint64_t seeds = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 10;
  const sizing::DesignProblem study(formats::read_study(argv[1]));
  const sizing::Problem problem = study.problem();
  sizing::SearchOptions options = study.study().search;
  if (argc > 3) options.max_evaluations = std::strtoull(argv[3], nullptr, 10);
  if (problem.objectives.size() > 1) {
    print_ends(study.study(), options, seeds);
    return 0;
  }
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
