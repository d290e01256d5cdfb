#pragma once

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "coilwright/sizing/problem/problem.hpp"

// What the problems of sizing_held_out and sizing_hard_fronts are written with.
namespace coilwright::sizing::testing {

using Point = std::span<const double>;
using Ranges = std::vector<std::pair<double, double>>;

inline double square(double value) {
  return value * value;
}

inline Ranges cube(std::size_t dimension, double upper = 1.0) {
  return Ranges(dimension, {0.0, upper});
}

/// Two minimised objectives, of variables x1, x2, .. without a grid.
inline Problem problem_of(const Ranges& ranges, std::vector<std::string> constraints,
                          std::function<Evaluation(Point)> evaluate) {
  Problem problem{.variables = {},
                  .objectives = {{.name = "f1"}, {.name = "f2"}},
                  .constraints = std::move(constraints),
                  .evaluate = std::move(evaluate)};
  for (std::size_t i = 0; i < ranges.size(); ++i)
    problem.variables.push_back(
        {.name = fmt::format("x{}", i + 1), .lower = ranges[i].first, .upper = ranges[i].second});
  return problem;
}

inline Evaluation values(double f1, double f2, std::vector<double> constraints = {}) {
  return {.objectives = {f1, f2}, .constraints = std::move(constraints), .failure = {}, .infeasibility = 0};
}

inline std::vector<Objectives> kept(const std::vector<Objectives>& points) {
  std::vector<Objectives> front;
  for (const std::size_t i : non_dominated(points)) front.push_back(points[i]);
  return front;
}

/// Feasible points of a curve of designs, without the dominated ones.
inline std::vector<Objectives> front_along(const Problem& problem, double from, double to,
                                           const std::function<std::vector<double>(double)>& design) {
  constexpr int count = 200'000;
  std::vector<Objectives> points;
  for (int i = 0; i <= count; ++i) {
    const Evaluation evaluation = problem.evaluate(design(std::lerp(from, to, static_cast<double>(i) / count)));
    if (is_feasible(evaluation)) points.push_back(evaluation.objectives);
  }
  return kept(points);
}

/// Designs with these values but for the first.
inline std::function<std::vector<double>(double)> others_at(std::vector<double> optimum) {
  return [optimum = std::move(optimum)](double x) {
    std::vector<double> design = optimum;
    design[0] = x;
    return design;
  };
}

}  // namespace coilwright::sizing::testing
