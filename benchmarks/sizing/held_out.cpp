// Prints the hypervolume over the true front's for problems that the search was not tuned on: they were run once, after
// its last change. Their fronts are curves in closed form or plain enumeration.
//
// usage: sizing_held_out [SEEDS [PROBLEM]]
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <string>
#include <vector>

#include "coilwright/sizing/problem/archive.hpp"
#include "coilwright/sizing/search/pareto.hpp"
#include "front_curves.hpp"

namespace {

using namespace coilwright::sizing;
using namespace coilwright::sizing::testing;

struct HeldOut {
  std::string name;
  std::size_t budget{};
  Problem problem;
  std::vector<Objectives> front;
};

// ZDT3 with its optimum inside the cube and a quadratic distance.
HeldOut shifted_zdt3() {
  std::vector<double> optimum(30);
  for (std::size_t i = 1; i < optimum.size(); ++i) optimum[i] = 0.3 + 0.4 * static_cast<double>(i) / 30;
  Problem problem = problem_of(cube(30), {}, [optimum](Point x) {
    double g = 1;
    for (std::size_t i = 1; i < x.size(); ++i) g += 9.0 / 29 * square((x[i] - optimum[i]) / 0.7);
    const double share = x[0] / g;
    return values(x[0], g * (1 - std::sqrt(share) - share * std::sin(10 * std::numbers::pi * x[0])));
  });
  std::vector<Objectives> front = front_along(problem, 0, 1, others_at(optimum));
  return {"ZDT3 shifted", 5000, std::move(problem), std::move(front)};
}

// ZDT2 whose distance couples neighbouring variables.
HeldOut coupled_zdt2() {
  Problem problem = problem_of(cube(15), {}, [](Point x) {
    double g = 1;
    for (std::size_t i = 1; i < x.size(); ++i) {
      const double before = i > 1 ? x[i - 1] : 0.4;
      g += square(x[i] - 0.5) + 4 * square(x[i] + before - 0.9) / 14;
    }
    const double floor = g - 1;
    return values(x[0], (1 + floor) * (1 - square(x[0] / (1 + floor))));
  });
  // The distance is a convex quadratic: its minimum by steps along each variable in turn.
  std::vector<double> best(15, 0.5);
  for (int sweep = 0; sweep < 2000; ++sweep) {
    for (std::size_t i = 1; i < best.size(); ++i) {
      const double before = i > 1 ? best[i - 1] : 0.4;
      double weight = 1 + 4.0 / 14, sum = 0.5 + 4.0 / 14 * (0.9 - before);
      if (i + 1 < best.size()) {
        weight += 4.0 / 14;
        sum += 4.0 / 14 * (0.9 - best[i + 1]);
      }
      best[i] = sum / weight;
    }
  }
  std::vector<Objectives> front = front_along(problem, 0, 1, others_at(best));
  return {"ZDT2 coupled", 5000, std::move(problem), std::move(front)};
}

// Deb, Thiele, Laumanns, Zitzler, CEC 2002, 825, with two objectives.
HeldOut dtlz7() {
  Problem problem = problem_of(cube(12), {}, [](Point x) {
    double sum = 0;
    for (const double value : x.subspan(1)) sum += value;
    const double g = 1 + 9 * sum / 11;
    return values(x[0], (1 + g) * (2 - x[0] / (1 + g) * (1 + std::sin(3 * std::numbers::pi * x[0]))));
  });
  std::vector<Objectives> front = front_along(problem, 0, 1, others_at(std::vector<double>(12, 0.0)));
  return {"DTLZ7", 5000, std::move(problem), std::move(front)};
}

// Jain, Deb, IEEE Trans. Evol. Comput. 18 (2014) 602, with two objectives: three pieces of the circle of DTLZ2.
HeldOut c2_dtlz2() {
  Problem problem = problem_of(cube(12), {"near a piece"}, [](Point x) {
    double radius = 1;
    for (const double value : x.subspan(1)) radius += square(value - 0.5);
    const double f1 = radius * std::cos(0.5 * std::numbers::pi * x[0]);
    const double f2 = radius * std::sin(0.5 * std::numbers::pi * x[0]);
    constexpr double r = 0.2;
    const double ends = std::min(square(f1 - 1) + square(f2), square(f2 - 1) + square(f1)) - r * r;
    const double middle = square(f1 - std::sqrt(0.5)) + square(f2 - std::sqrt(0.5)) - r * r;
    return values(f1, f2, {std::min(ends, middle)});
  });
  std::vector<Objectives> front = front_along(problem, 0, 1, others_at(std::vector<double>(12, 0.5)));
  return {"C2-DTLZ2", 5000, std::move(problem), std::move(front)};
}

// Poloni's problem, minimised: 2001^2 designs enumerated.
HeldOut poloni() {
  constexpr double pi = std::numbers::pi;
  Problem problem = problem_of({{-pi, pi}, {-pi, pi}}, {}, [](Point x) {
    const auto b1 = [](double a, double b) {
      return 0.5 * std::sin(a) - 2 * std::cos(a) + std::sin(b) - 1.5 * std::cos(b);
    };
    const auto b2 = [](double a, double b) {
      return 1.5 * std::sin(a) - std::cos(a) + 2 * std::sin(b) - 0.5 * std::cos(b);
    };
    return values(1 + square(b1(1, 2) - b1(x[0], x[1])) + square(b2(1, 2) - b2(x[0], x[1])),
                  square(x[0] + 3) + square(x[1] + 1));
  });
  constexpr int fine = 2000;
  std::vector<Objectives> points;
  for (int i = 0; i <= fine; ++i)
    for (int k = 0; k <= fine; ++k) {
      const double x[2] = {std::lerp(-pi, pi, static_cast<double>(i) / fine),
                           std::lerp(-pi, pi, static_cast<double>(k) / fine)};
      points.push_back(problem.evaluate(x).objectives);
    }
  return {"Poloni", 2000, std::move(problem), kept(points)};
}

void run(const HeldOut& held_out, std::uint64_t seeds) {
  const FrontFrame frame = frame_of(held_out.front);
  const double whole = normalised_hypervolume(held_out.front, frame);
  std::vector<double> ratios;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const ParetoResult result = pareto(held_out.problem, {.max_evaluations = held_out.budget, .seed = seed});
    ratios.push_back(normalised_hypervolume(minimised(held_out.problem, result.front), frame) / whole);
  }
  std::ranges::sort(ratios);
  fmt::print("{:<14} {:>6} {:>8.4f} {:>8.4f}\n", held_out.name, held_out.budget, ratios.front(),
             ratios[ratios.size() / 2]);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const std::uint64_t seeds = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 10;
  const std::string only = argc > 2 ? argv[2] : "";
  fmt::print("{:<14} {:>6} {:>8} {:>8}\n", "problem", "budget", "worst", "median");
  for (const auto& make : {shifted_zdt3, coupled_zdt2, dtlz7, c2_dtlz2, poloni}) {
    const HeldOut held_out = make();
    if (only.empty() || only == held_out.name) run(held_out, seeds);
  }
}
