// Prints the hypervolume over the true front's for problems on which searches fail: thin feasible sets, fronts in
// pieces, many local fronts; with 210 (as published for Bayesian searches), 800 and 5,000 evaluations.
//
// usage: sizing_hard_fronts [SEEDS [PROBLEM [EVALUATIONS]]]
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "coilwright/sizing/problem/archive.hpp"
#include "coilwright/sizing/search/pareto.hpp"
#include "front_curves.hpp"
#include "sizing/front_problems.hpp"

namespace {

using namespace coilwright::sizing;
using namespace coilwright::sizing::testing;
using std::numbers::pi;

struct HardFront {
  std::string name;
  Problem problem;
  std::vector<Objectives> front;
};

// Objectives and constraints of a first variable and a distance, of which the others decide only the distance.
using Plane = std::function<Evaluation(double x1, double g)>;

// For each of 20,001 values of x1, closest at the ends, the least distance that is feasible: both objectives grow with
// it. Steps of 5e-5 in the distance lack less than 1e-4 of the hypervolume.
std::vector<Objectives> front_of(const Plane& plane, double upper, double least) {
  constexpr int fine = 20'000;
  std::vector<Objectives> points;
  for (int i = 0; i <= fine; ++i)
    for (int k = 0; k <= fine / 2; ++k) {
      const Evaluation evaluation = plane(upper * 0.5 * (1 - std::cos(pi * i / fine)), least + 5e-5 * k);
      if (!is_feasible(evaluation)) continue;
      points.push_back(evaluation.objectives);
      break;
    }
  return kept(points);
}

// Ma, Wang, IEEE Trans. Evol. Comput. 23 (2019) 972. Each variable leads to the next: the distance is a valley.
double valley(Point x) {
  double g = 1;
  for (std::size_t i = 1; i < x.size(); ++i) g += 2 * square(x[i] + square(x[i - 1] - 0.5) - 1);
  return g;
}

HardFront mw(std::string name, std::size_t dimension, double upper, std::vector<std::string> limits, Plane plane) {
  Problem problem =
      problem_of(cube(dimension, upper), std::move(limits), [plane](Point x) { return plane(x[0], valley(x)); });
  return {fmt::format("{} ({})", name, dimension), std::move(problem), front_of(plane, upper, 1.0)};
}

// A band along a line.
HardFront mw3(std::size_t dimension) {
  return mw("MW3", dimension, 1.0, {"below", "above"}, [](double x1, double g) {
    const double f2 = g - x1, wave = std::sin(0.75 * pi * std::numbers::sqrt2 * (f2 - x1));
    return values(x1, f2, {g - 1.05 - 0.45 * std::pow(wave, 6), 0.85 + 0.3 * square(wave) - g});
  });
}

// A band along a circle.
HardFront mw7(std::size_t dimension) {
  return mw("MW7", dimension, 1.0, {"below", "above"}, [](double x1, double g) {
    const double f1 = g * x1, f2 = g * std::sqrt(1 - square(x1)), wave = std::sin(4 * std::atan2(f2, f1));
    return values(
        f1, f2,
        {square(g) - square(1.2 + 0.4 * std::pow(wave, 16)), square(1.15 - 0.2 * std::pow(wave, 8)) - square(g)});
  });
}

// Pieces in a strip of which the height is a fiftieth.
HardFront mw14(std::size_t dimension) {
  return mw("MW14", dimension, 1.5, {"strip"}, [](double x1, double g) {
    const double wave = 1.5 * std::sin(1.1 * pi * square(x1)), f2 = g * (6 - std::exp(x1) - wave);
    return values(x1, f2, {f2 - (5.1 - x1 - 0.5 * square(x1) - wave)});
  });
}

// Fan, Li, Cai et al., Evol. Comput. 28 (2020) 339, with all difficulties 0.25: intervals of x1, a distance from 0.5 to
// 1.9, ellipses to be kept out of.
HardFront das_cmop1() {
  const Plane plane = [](double x1, double g) {
    const double f1 = x1 + g, f2 = 1 - square(x1) + g;
    std::vector<double> limits{-0.5 - std::sin(20 * pi * x1), -(0.5 - std::log(0.25) - g) * (g - 0.5)};
    constexpr double p[] = {0, 1, 0, 1, 2, 0, 1, 2, 3}, q[] = {1.5, 0.5, 2.5, 1.5, 0.5, 3.5, 2.5, 1.5, 0.5};
    for (int k = 0; k < 9; ++k)
      limits.push_back(0.125 - square(f1 - p[k] + f2 - q[k]) / 0.6 - square(f2 - q[k] - f1 + p[k]) / 2.4);
    return values(f1, f2, limits);
  };
  std::vector<std::string> names{"intervals", "distance"};
  for (int k = 1; k <= 9; ++k) names.push_back(fmt::format("ellipse {}", k));
  Problem problem = problem_of(cube(30), names, [plane](Point x) {
    double g = 0;
    for (const double value : x.subspan(1)) g += square(value - std::sin(0.5 * pi * x[0]));
    return plane(x[0], g);
  });
  return {"DAS-CMOP1", std::move(problem), front_of(plane, 1.0, 0.5)};
}

// ZDT4 (Zitzler, Deb, Thiele 2000) with waves of a tenth of the height: still 21^9 local fronts.
HardFront milder_zdt4() {
  Ranges ranges(10, {-5.0, 5.0});
  ranges[0] = {0.0, 1.0};
  Problem problem = problem_of(ranges, {}, [](Point x) {
    double g = 1;
    for (const double value : x.subspan(1)) g += square(value) + 1 - std::cos(4 * pi * value);
    return values(x[0], g * (1 - std::sqrt(x[0] / g)));
  });
  std::vector<Objectives> front = front_along(problem, 0, 1, others_at(std::vector<double>(10, 0.0)));
  return {"ZDT4 milder", std::move(problem), std::move(front)};
}

HardFront pieces() {
  return {"ZDT3", zdt3(), front_along(zdt3(), 0, 1, others_at(std::vector<double>(30, 0.0)))};
}

HardFront wave() {
  return {"TNK", tnk(), front_along(tnk(), 0, pi / 2, [](double angle) {
            const double radius = std::sqrt(1 + 0.1 * std::cos(16 * angle)) * (1 + 1e-12);
            return std::vector<double>{radius * std::sin(angle), radius * std::cos(angle)};
          })};
}

void run(const HardFront& hard, std::size_t evaluations, std::uint64_t seeds) {
  const FrontFrame frame = frame_of(hard.front);
  const double whole = normalised_hypervolume(hard.front, frame);
  std::vector<double> ratios;
  std::size_t latest = 0;  // design that is the first feasible one, over the seeds
  const auto start = std::chrono::steady_clock::now();
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const ParetoResult result = pareto(hard.problem, {.max_evaluations = evaluations, .seed = seed});
    ratios.push_back(normalised_hypervolume(minimised(hard.problem, result.front), frame) / whole);
    std::size_t first = evaluations + 1;
    for (const Record& record : result.archive.records())
      if (is_feasible(record.evaluation)) first = std::min(first, record.number);
    latest = std::max(latest, first);
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::ranges::sort(ratios);
  fmt::print("{:<12} {:>6} {:>7.3f} {:>7.3f} {:>9} {:>8.3f}\n", hard.name, evaluations, ratios.front(),
             ratios[ratios.size() / 2], latest > evaluations ? "none" : fmt::format("{}", latest),
             1e3 * seconds / static_cast<double>(seeds * evaluations));
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const std::uint64_t seeds = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 5;
  const std::string only = argc > 2 ? argv[2] : "";
  std::vector<std::size_t> budgets{210, 800, 5000};
  if (argc > 3) budgets = {std::strtoull(argv[3], nullptr, 10)};
  fmt::print("{:<12} {:>6} {:>7} {:>7} {:>9} {:>8}\n", "problem", "budget", "worst", "median", "feasible", "ms/eval");
  const std::vector<std::function<HardFront()>> problems{[] { return mw3(8); },
                                                         [] { return mw3(12); },
                                                         [] { return mw3(15); },
                                                         [] { return mw7(8); },
                                                         [] { return mw7(15); },
                                                         [] { return mw14(15); },
                                                         pieces,
                                                         milder_zdt4,
                                                         das_cmop1,
                                                         wave};
  for (const auto& make : problems) {
    const HardFront hard = make();
    if (only.empty() || hard.name.starts_with(only))
      for (const std::size_t budget : budgets) run(hard, budget, seeds);
  }
}
