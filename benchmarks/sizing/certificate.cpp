// The search on the real problem, against the truth: enumerates a whole grid of designs, then searches it with one
// hundredth of the evaluations and several seeds, and prints the ratio of the hypervolumes.
//
// usage: sizing_certificate configs/studies/certificate.json
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <vector>

#include "coilwright/formats/study/study_file.hpp"
#include "coilwright/sizing/search/pareto.hpp"
#include "coilwright/sizing/study/design_problem.hpp"
#include "coilwright/sizing/study/sweep.hpp"

namespace {

using namespace coilwright;

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Of the whole grid: the feasible designs that no other dominates.
std::vector<sizing::Objectives> true_front(const sizing::DesignProblem& study, const sizing::Problem& problem) {
  std::vector<sizing::Objectives> feasible;
  std::size_t failed = 0;
  const auto start = std::chrono::steady_clock::now();
  const std::size_t count = sizing::sweep(study, {}, [&](const sizing::SweptDesign& design) {
    if (!design.evaluation.failure.empty()) ++failed;
    if (sizing::is_feasible(design.evaluation)) feasible.push_back(sizing::minimised(problem, design.evaluation));
  });
  std::vector<sizing::Objectives> front;
  for (const std::size_t i : sizing::non_dominated(feasible)) front.push_back(feasible[i]);
  fmt::print("enumerated {} designs in {:.1f} s: {} feasible, {} failed, {} on the front\n", count,
             seconds_since(start), feasible.size(), failed, front.size());
  return front;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "usage: sizing_certificate STUDY.json\n");
    return 2;
  }
  const sizing::DesignProblem study(formats::read_study(argv[1]));
  const sizing::Problem problem = study.problem();
  const std::vector<sizing::Objectives> truth = true_front(study, problem);
  const sizing::FrontFrame frame = sizing::frame_of(truth);
  const double whole = sizing::normalised_hypervolume(truth, frame);

  sizing::ParetoOptions options = study.study().search;
  options.max_evaluations = study.point_count() / 100;
  std::vector<double> ratios;
  for (options.seed = 1; options.seed <= 10; ++options.seed) {
    const auto start = std::chrono::steady_clock::now();
    const sizing::ParetoResult result = sizing::pareto(problem, options);
    const std::vector<sizing::Objectives> front = sizing::minimised(problem, result.front);
    ratios.push_back(sizing::normalised_hypervolume(front, frame) / whole);
    fmt::print("seed {:>2}: {} evaluations, {} on the front, hypervolume ratio {:.5f}, {:.2f} s\n", options.seed,
               result.evaluations, front.size(), ratios.back(), seconds_since(start));
  }
  std::ranges::sort(ratios);
  fmt::print("worst {:.5f}, median {:.5f}; asked for: 0.995\n", ratios.front(), ratios[ratios.size() / 2]);
  return ratios.front() >= 0.995 ? 0 : 1;
}
