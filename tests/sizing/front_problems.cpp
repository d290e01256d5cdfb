#include "sizing/front_problems.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <map>
#include <numbers>
#include <sstream>
#include <stdexcept>

#include "coilwright/sizing/problem/archive.hpp"

namespace coilwright::sizing::testing {
namespace {

using Point = std::span<const double>;

Variable real_variable(std::string name, double lower, double upper) {
  return {.name = std::move(name), .kind = VariableKind::continuous, .lower = lower, .upper = upper, .step = 0};
}

Variable whole(std::string name, double lower, double upper) {
  return {.name = std::move(name), .kind = VariableKind::integer, .lower = lower, .upper = upper, .step = 0};
}

Variable gridded(std::string name, double lower, double upper, double step) {
  return {.name = std::move(name), .kind = VariableKind::continuous, .lower = lower, .upper = upper, .step = step};
}

std::vector<Objective> two_minimised() {
  return {{.name = "f1", .sense = Sense::minimise}, {.name = "f2", .sense = Sense::minimise}};
}

Evaluation evaluated(std::vector<double> objectives, std::vector<double> constraints) {
  return {
      .objectives = std::move(objectives), .constraints = std::move(constraints), .failure = {}, .infeasibility = 0};
}

double square(double value) {
  return value * value;
}

}  // namespace

Problem re21() {
  const double root2 = std::numbers::sqrt2;
  return {.variables = {real_variable("x1", 1, 3), real_variable("x2", root2, 3), real_variable("x3", root2, 3),
                        real_variable("x4", 1, 3)},
          .objectives = two_minimised(),
          .constraints = {},
          .evaluate = [root2](Point x) {
            constexpr double force = 10, modulus = 2e5, length = 200;
            return evaluated({length * (2 * x[0] + root2 * x[1] + std::sqrt(x[2]) + x[3]),
                              force * length / modulus * (2 / x[0] + 2 * root2 / x[1] - 2 * root2 / x[2] + 2 / x[3])},
                             {});
          }};
}

Problem bnh() {
  return {.variables = {real_variable("x1", 0, 5), real_variable("x2", 0, 3)},
          .objectives = two_minimised(),
          .constraints = {"inside", "outside"},
          .evaluate = [](Point x) {
            return evaluated(
                {4 * square(x[0]) + 4 * square(x[1]), square(x[0] - 5) + square(x[1] - 5)},
                {(square(x[0] - 5) + square(x[1]) - 25) / 25, (7.7 - square(x[0] - 8) - square(x[1] + 3)) / 7.7});
          }};
}

Problem srn() {
  return {.variables = {real_variable("x1", -20, 20), real_variable("x2", -20, 20)},
          .objectives = two_minimised(),
          .constraints = {"circle", "line"},
          .evaluate = [](Point x) {
            return evaluated({2 + square(x[0] - 2) + square(x[1] - 1), 9 * x[0] - square(x[1] - 1)},
                             {(square(x[0]) + square(x[1]) - 225) / 225, (x[0] - 3 * x[1] + 10) / 10});
          }};
}

Problem tnk() {
  return {.variables = {real_variable("x1", 0, std::numbers::pi), real_variable("x2", 0, std::numbers::pi)},
          .objectives = two_minimised(),
          .constraints = {"wave", "disc"},
          .evaluate = [](Point x) {
            return evaluated({x[0], x[1]},
                             {1 + 0.1 * std::cos(16 * std::atan2(x[0], x[1])) - square(x[0]) - square(x[1]),
                              (square(x[0] - 0.5) + square(x[1] - 0.5) - 0.5) / 0.5});
          }};
}

Problem zdt1() {
  Problem problem{.variables = {}, .objectives = two_minimised(), .constraints = {}, .evaluate = [](Point x) {
                    double sum = 0;
                    for (const double value : x.subspan(1)) sum += value;
                    const double g = 1 + 9 * sum / static_cast<double>(x.size() - 1);
                    return evaluated({x[0], g * (1 - std::sqrt(x[0] / g))}, {});
                  }};
  for (int i = 1; i <= 30; ++i)
    problem.variables.push_back(real_variable(std::string{"x"}.append(std::to_string(i)), 0, 1));
  return problem;
}

namespace {

// Variables x1 to xn in [0, 1] and the two objectives of a ZDT or DTLZ problem.
Problem in_unit_cube(int dimension, std::function<Evaluation(Point)> evaluate) {
  Problem problem{.variables = {}, .objectives = two_minimised(), .constraints = {}, .evaluate = std::move(evaluate)};
  for (int i = 1; i <= dimension; ++i)
    problem.variables.push_back(real_variable(std::string{"x"}.append(std::to_string(i)), 0, 1));
  return problem;
}

double mean_of(Point values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

}  // namespace

Problem zdt2() {
  return in_unit_cube(30, [](Point x) {
    const double g = 1 + 9 * mean_of(x.subspan(1));
    return evaluated({x[0], g * (1 - square(x[0] / g))}, {});
  });
}

Problem zdt3() {
  return in_unit_cube(30, [](Point x) {
    const double g = 1 + 9 * mean_of(x.subspan(1)), share = x[0] / g;
    return evaluated({x[0], g * (1 - std::sqrt(share) - share * std::sin(10 * std::numbers::pi * x[0]))}, {});
  });
}

Problem zdt6() {
  return in_unit_cube(10, [](Point x) {
    const double f1 = 1 - std::exp(-4 * x[0]) * std::pow(std::sin(6 * std::numbers::pi * x[0]), 6);
    const double g = 1 + 9 * std::pow(mean_of(x.subspan(1)), 0.25);
    return evaluated({f1, g * (1 - square(f1 / g))}, {});
  });
}

Problem dtlz2() {
  return in_unit_cube(12, [](Point x) {
    double radius = 1;
    for (const double value : x.subspan(1)) radius += square(value - 0.5);
    const double angle = 0.5 * std::numbers::pi * x[0];
    return evaluated({radius * std::cos(angle), radius * std::sin(angle)}, {});
  });
}

Problem cre25() {
  return {.variables = {whole("x1", 12, 60), whole("x2", 12, 60), whole("x3", 12, 60), whole("x4", 12, 60)},
          .objectives = two_minimised(),
          .constraints = {"error"},
          .evaluate = [](Point x) {
            const double error = std::abs(6.931 - x[2] / x[0] * x[3] / x[1]);
            return evaluated({error, std::ranges::max(x)}, {error / 6.931 - 0.5});
          }};
}

Problem osy() {
  return {
      .variables = {real_variable("x1", 0, 10), real_variable("x2", 0, 10), real_variable("x3", 1, 5),
                    real_variable("x4", 0, 6), real_variable("x5", 1, 5), real_variable("x6", 0, 10)},
      .objectives = two_minimised(),
      .constraints = {"g1", "g2", "g3", "g4", "g5", "g6"},
      .evaluate = [](Point x) {
        double sum = 0;
        for (const double value : x) sum += square(value);
        return evaluated(
            {-(25 * square(x[0] - 2) + square(x[1] - 2) + square(x[2] - 1) + square(x[3] - 4) + square(x[4] - 1)), sum},
            {(2 - x[0] - x[1]) / 2, (x[0] + x[1] - 6) / 6, (x[1] - x[0] - 2) / 2, (x[0] - 3 * x[1] - 2) / 2,
             (square(x[2] - 3) + x[3] - 4) / 4, (4 - square(x[4] - 3) - x[5]) / 4});
      }};
}

std::vector<FrontProblem> front_problems(const std::string& file) {
  std::vector<FrontProblem> problems;
  const auto add = [&](const char* name, Problem problem, std::size_t budget, double target) {
    problems.push_back({.name = name,
                        .problem = std::move(problem),
                        .budget = budget,
                        .target = target,
                        .frame = {},
                        .hypervolume = 0});
  };
  add("RE21", re21(), 2000, 0.995);
  add("BNH", bnh(), 2000, 0.996);
  add("SRN", srn(), 2000, 0.994);
  add("TNK", tnk(), 5000, 0.985);
  add("ZDT1", zdt1(), 5000, 0.99);
  add("ZDT1_2000", zdt1(), 2000, 0.97);
  add("ZDT2", zdt2(), 5000, 0.97);
  add("ZDT3", zdt3(), 5000, 0.97);
  add("ZDT6", zdt6(), 5000, 0.97);
  add("DTLZ2", dtlz2(), 2000, 0.97);
  add("CRE25", cre25(), 5000, 0.999);
  add("OSY", osy(), 10000, 0.98);
  std::ifstream input{file};
  std::string line;
  std::size_t read = 0;
  while (std::getline(input, line)) {
    std::ranges::replace(line, ',', ' ');
    std::istringstream words{line};
    std::string name;
    words >> name;
    const auto found = std::ranges::find(problems, name, &FrontProblem::name);
    if (found == problems.end()) continue;
    found->frame = {.ideal = Objectives(2), .nadir = Objectives(2)};
    words >> found->frame.ideal[0] >> found->frame.nadir[0] >> found->frame.ideal[1] >> found->frame.nadir[1] >>
        found->hypervolume;
    if (!words) throw std::runtime_error(file + ": cannot read the line of " + name);
    ++read;
  }
  if (read != problems.size()) throw std::runtime_error(file + ": does not hold every problem");
  return problems;
}

double hypervolume_ratio(const FrontProblem& problem, const std::vector<Objectives>& points) {
  return normalised_hypervolume(points, problem.frame) / problem.hypervolume;
}

Problem winding_grid(GridObjectives objectives) {
  Problem problem{
      .variables = {{.name = "configuration", .kind = VariableKind::categorical, .lower = 0, .upper = 3, .step = 0},
                    whole("gauge", 26, 37),
                    whole("radial_turns", 2, 16),
                    whole("axial_turns", 4, 27),
                    gridded("magnet_radius", 2.0, 4.0, 0.25),
                    gridded("gap", 0.5, 2.5, 1.0)},
      .objectives = {{.name = "torque", .sense = Sense::maximise}, {.name = "mass", .sense = Sense::minimise}},
      .constraints = {"outer_radius", "power", "reach"},
      .evaluate = {}};
  problem.variables[5].step = 0.5;
  if (objectives == GridObjectives::three) problem.objectives.push_back({.name = "power", .sense = Sense::minimise});
  const std::size_t count = problem.objectives.size();
  problem.evaluate = [count](Point x) {
    const auto configuration = static_cast<int>(x[0]);
    const double wire = 8.25 * std::pow(0.8905, x[1]);  // mm, close to AWG with insulation
    const double inner = x[4] + 0.4, radial = x[2] * wire, axial = x[3] * wire, outer = inner + radial;
    const double room = (configuration == 3 ? 5.0 : 6.5) + 0.4 * x[4];
    if (axial > room) {
      return Evaluation{.objectives = {},
                        .constraints = {},
                        .failure = "winding longer than its segment",
                        .infeasibility = (axial - room) / room};
    }
    const double turns = x[2] * x[3], mean = inner + 0.5 * radial;
    const double resistance = 2.2e-5 * turns * 6.283 * mean / square(wire * 0.9);
    const double current = std::min(2.0, 7.0 * square(wire));  // A, from the section
    const double coils = configuration == 0 ? 1 : 2, magnets = configuration == 1 ? 1 : configuration == 2 ? 2 : 1.5;
    const double power = coils * square(current) * resistance;
    const double field = std::pow(x[4], 3) / std::pow(square(mean) + square(0.5 * axial + x[5]), 1.5);
    const double asymmetry = configuration == 3 ? 1.15 : configuration == 2 ? 1.25 - 0.08 * x[4] : 1.0;
    const double torque = coils * std::sqrt(magnets) * turns * current * field * asymmetry *
                          (1 - 0.12 * std::sin(2.0 * x[5] + 0.3 * x[2]));
    const double copper = 8.96e-3 * 6.283 * mean * turns * 0.785 * square(wire * 0.9);
    const double mass = 1.5 + coils * copper + magnets * 7.5e-3 * 3.1416 * square(x[4]) * 5.0;
    std::vector<double> values{torque, mass};
    if (count == 3) values.push_back(power);
    return evaluated(std::move(values), {outer / 7.0 - 1, power / 3.0 - 1, (x[5] + axial) / 7.5 - 1});
  };
  return problem;
}

std::vector<Objectives> enumerate_feasible(const Problem& problem) {
  std::vector<Objectives> result;
  std::vector<std::size_t> index(problem.variables.size(), 0);
  std::vector<double> point(index.size());
  for (;;) {
    for (std::size_t i = 0; i < index.size(); ++i) {
      const Variable& variable = problem.variables[i];
      point[i] = variable.lower + static_cast<double>(index[i]) * (variable.step > 0 ? variable.step : 1.0);
    }
    const Evaluation evaluation = evaluate_checked(problem, point);
    if (is_feasible(evaluation)) result.push_back(minimised(problem, evaluation));
    std::size_t i = 0;
    for (; i < index.size(); ++i) {
      const Variable& variable = problem.variables[i];
      const double next = variable.lower + static_cast<double>(index[i] + 1) * (variable.step > 0 ? variable.step : 1);
      if (next <= variable.upper + 1e-9) {
        ++index[i];
        break;
      }
      index[i] = 0;
    }
    if (i == index.size()) return result;
  }
}

}  // namespace coilwright::sizing::testing
