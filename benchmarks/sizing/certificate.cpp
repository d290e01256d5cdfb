// The search on the real problem, against the truth: enumerates a whole grid of designs, then searches it with one
// hundredth of the evaluations and several seeds, and prints the ratio of the hypervolumes.
//
// usage: sizing_certificate configs/studies/certificate.json [CACHE.csv]
//
// With a cache the true front is written there, and read again by the next run unless the study or the physics changed:
// the first line has the number of designs and a checksum over 257 of them, evaluated anew.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "coilwright/formats/study/study_file.hpp"
#include "coilwright/sizing/search/pareto.hpp"
#include "coilwright/sizing/study/design_problem.hpp"
#include "coilwright/sizing/study/sweep.hpp"

namespace {

using namespace coilwright;
using Front = std::vector<sizing::Objectives>;

constexpr std::size_t designs_between_reports = 10'000;

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Of the bits of what some designs all over the grid give: another physics, another number.
std::uint64_t checksum(const sizing::DesignProblem& study, const sizing::Problem& problem) {
  constexpr std::size_t samples = 257;
  std::uint64_t sum = 0xCBF29CE484222325ULL;
  const auto take = [&sum](std::uint64_t bits) { sum = (sum ^ bits) * 0x100000001B3ULL; };
  for (std::size_t i = 0; i < samples; ++i) {
    const sizing::Evaluation evaluation = problem.evaluate(study.point(study.point_count() / samples * i));
    for (const double value : evaluation.objectives) take(std::bit_cast<std::uint64_t>(value));
    for (const double value : evaluation.constraints) take(std::bit_cast<std::uint64_t>(value));
    take(evaluation.failure.size());
  }
  return sum;
}

// Of the whole grid: the feasible designs that no other dominates.
Front enumerated(const sizing::DesignProblem& study, const sizing::Problem& problem) {
  Front feasible;
  std::size_t failed = 0;
  const auto start = std::chrono::steady_clock::now();
  const std::size_t count = sizing::sweep(study, {}, [&](const sizing::SweptDesign& design) {
    if (!design.evaluation.failure.empty()) ++failed;
    if (sizing::is_feasible(design.evaluation)) feasible.push_back(sizing::minimised(problem, design.evaluation));
    if ((design.index + 1) % designs_between_reports != 0) return;
    const double seconds = seconds_since(start);
    const double left =
        seconds / static_cast<double>(design.index + 1) * static_cast<double>(study.point_count() - design.index - 1);
    fmt::print(stderr, "{} of {} designs in {:.0f} s, {:.0f} s left\n", design.index + 1, study.point_count(), seconds,
               left);
  });
  Front front;
  for (const std::size_t i : sizing::non_dominated(feasible)) front.push_back(feasible[i]);
  fmt::print("enumerated {} designs in {:.1f} s: {} feasible, {} failed, {} on the front\n", count,
             seconds_since(start), feasible.size(), failed, front.size());
  return front;
}

std::optional<Front> cached(const std::string& file, const std::string& head) {
  std::ifstream in(file);
  std::string line;
  if (!std::getline(in, line) || line != head) return std::nullopt;
  Front front;
  while (std::getline(in, line)) {
    std::ranges::replace(line, ',', ' ');
    std::istringstream words(line);
    front.emplace_back();
    for (double value{}; words >> value;) front.back().push_back(value);
  }
  fmt::print("the true front of {} designs is from {}\n", front.size(), file);
  return front;
}

Front true_front(const sizing::DesignProblem& study, const sizing::Problem& problem, const std::string& cache) {
  if (cache.empty()) return enumerated(study, problem);
  const std::string head = fmt::format("{} designs, checksum {:016x}", study.point_count(), checksum(study, problem));
  if (std::optional<Front> front = cached(cache, head)) return *std::move(front);
  Front front = enumerated(study, problem);
  std::ofstream out(cache);
  out << head << '\n';
  for (const sizing::Objectives& point : front) out << fmt::format("{}\n", fmt::join(point, ","));
  return front;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2 && argc != 3) {
    fmt::print(stderr, "usage: sizing_certificate STUDY.json [CACHE.csv]\n");
    return 2;
  }
  const sizing::DesignProblem study(formats::read_study(argv[1]));
  const sizing::Problem problem = study.problem();
  const Front truth = true_front(study, problem, argc == 3 ? argv[2] : "");
  const sizing::FrontFrame frame = sizing::frame_of(truth);
  const double whole = sizing::normalised_hypervolume(truth, frame);

  sizing::ParetoOptions options = study.study().search;
  options.max_evaluations = study.point_count() / 100;
  std::vector<double> ratios;
  for (options.seed = 1; options.seed <= 10; ++options.seed) {
    const auto start = std::chrono::steady_clock::now();
    const sizing::ParetoResult result = sizing::pareto(problem, options);
    const Front front = sizing::minimised(problem, result.front);
    ratios.push_back(sizing::normalised_hypervolume(front, frame) / whole);
    fmt::print("seed {:>2}: {} evaluations, {} on the front, hypervolume ratio {:.5f}, {:.2f} s\n", options.seed,
               result.evaluations, front.size(), ratios.back(), seconds_since(start));
  }
  std::ranges::sort(ratios);
  fmt::print("worst {:.5f}, median {:.5f}; asked for: 0.995\n", ratios.front(), ratios[ratios.size() / 2]);
  return ratios.front() >= 0.995 ? 0 : 1;
}
