#include "sizing/best_problems.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace coilwright::sizing::testing {
namespace {

using Point = std::span<const double>;

Variable real(const char* name, double lower, double upper, double step = 0) {
  return {.name = name, .kind = VariableKind::continuous, .lower = lower, .upper = upper, .step = step};
}

Evaluation cost(double value, std::vector<double> constraints) {
  return {.objectives = {value}, .constraints = std::move(constraints), .failure = {}, .infeasibility = 0};
}

std::vector<Objective> one_cost() {
  return {{.name = "cost", .sense = Sense::minimise}};
}

// Weight of a tension spring: wire and coil diameter, active coils.
Problem spring() {
  return {.variables = {real("wire", 0.05, 2), real("coil", 0.25, 1.3), real("turns", 2, 15)},
          .objectives = one_cost(),
          .constraints = {"deflection", "shear", "surge", "diameter"},
          .evaluate = [](Point x) {
            const double d = x[0], c = x[1], n = x[2];
            return cost((n + 2) * c * d * d,
                        {1 - c * c * c * n / (71785 * std::pow(d, 4)),
                         (4 * c * c - d * c) / (12566 * (c * d * d * d - std::pow(d, 4))) + 1 / (5108 * d * d) - 1,
                         1 - 140.45 * d / (c * c * n), (c + d) / 1.5 - 1});
          }};
}

// Cost of a pressure vessel: plate thicknesses come in sixteenths of an inch.
Problem vessel() {
  return {.variables = {real("shell", 0.0625, 6.1875, 0.0625), real("head", 0.0625, 6.1875, 0.0625),
                        real("radius", 10, 200), real("length", 10, 200)},
          .objectives = one_cost(),
          .constraints = {"shell", "head", "volume", "length"},
          .evaluate = [](Point x) {
            const double s = x[0], h = x[1], r = x[2], l = x[3];
            const double volume = std::numbers::pi * r * r * (l + 4.0 / 3 * r);
            return cost(0.6224 * s * r * l + 1.7781 * h * r * r + 3.1661 * s * s * l + 19.84 * s * s * r,
                        {0.0193 * r - s, 0.00954 * r - h, 1 - volume / 1296000, l / 240 - 1});
          }};
}

// Cost of a welded beam: weld height and length, bar height and thickness.
Problem beam() {
  return {.variables = {real("h", 0.1, 2), real("l", 0.1, 10), real("t", 0.1, 10), real("b", 0.1, 2)},
          .objectives = one_cost(),
          .constraints = {"shear", "bending", "weld", "cost", "height", "deflection", "buckling"},
          .evaluate = [](Point x) {
            const double h = x[0], l = x[1], t = x[2], b = x[3];
            const double load = 6000, arm = 14, young = 30e6, rigidity = 12e6, root2 = std::numbers::sqrt2;
            const double primary = load / (root2 * h * l), moment = load * (arm + l / 2);
            const double half = std::sqrt(l * l / 4 + (h + t) * (h + t) / 4);
            const double polar = 2 * root2 * h * l * (l * l / 12 + (h + t) * (h + t) / 4);
            const double secondary = moment * half / polar;
            const double shear = std::sqrt(primary * primary + primary * secondary * l / half + secondary * secondary);
            const double bending = 6 * load * arm / (b * t * t),
                         sag = 4 * load * std::pow(arm, 3) / (young * b * t * t * t);
            const double buckling = 4.013 * young * std::sqrt(t * t * std::pow(b, 6) / 36) / (arm * arm) *
                                    (1 - t / (2 * arm) * std::sqrt(young / (4 * rigidity)));
            const double material = 0.04811 * t * b * (14 + l);
            return cost(1.10471 * h * h * l + material,
                        {shear / 13600 - 1, bending / 30000 - 1, h - b, (0.10471 * h * h + material) / 5 - 1, 0.125 - h,
                         sag / 0.25 - 1, 1 - buckling / load});
          }};
}

// Weight of a speed reducer; the number of teeth is whole.
Problem reducer() {
  Problem problem{.variables = {real("face", 2.6, 3.6), real("module", 0.7, 0.8), real("teeth", 17, 28),
                                real("l1", 7.3, 8.3), real("l2", 7.3, 8.3), real("d1", 2.9, 3.9), real("d2", 5, 5.5)},
                  .objectives = one_cost(),
                  .constraints = {"g1", "g2", "g3", "g4", "g5", "g6", "g7", "g8", "g9", "g10", "g11"},
                  .evaluate = [](Point x) {
                    const double b = x[0], m = x[1], z = x[2], p = x[3], q = x[4], d = x[5], e = x[6];
                    const double weight = 0.7854 * b * m * m * (3.3333 * z * z + 14.9334 * z - 43.0934) -
                                          1.508 * b * (d * d + e * e) + 7.4777 * (d * d * d + e * e * e) +
                                          0.7854 * (p * d * d + q * e * e);
                    const double first = std::sqrt(std::pow(745 * p / (m * z), 2) + 16.9e6) / (110 * d * d * d);
                    const double second = std::sqrt(std::pow(745 * q / (m * z), 2) + 157.5e6) / (85 * e * e * e);
                    return cost(weight,
                                {27 / (b * m * m * z) - 1, 397.5 / (b * m * m * z * z) - 1,
                                 1.93 * p * p * p / (m * z * std::pow(d, 4)) - 1,
                                 1.93 * q * q * q / (m * z * std::pow(e, 4)) - 1, first - 1, second - 1, m * z / 40 - 1,
                                 5 * m / b - 1, b / (12 * m) - 1, (1.5 * d + 1.9) / p - 1, (1.1 * e + 1.9) / q - 1});
                  }};
  problem.variables[2].kind = VariableKind::integer;
  return problem;
}

Problem hartmann() {
  Problem problem{
      .variables = {}, .objectives = one_cost(), .constraints = {}, .evaluate = [](Point x) {
        constexpr std::array<double, 4> height{1.0, 1.2, 3.0, 3.2};
        constexpr std::array<std::array<double, 6>, 4> width{{{10, 3, 17, 3.5, 1.7, 8},
                                                              {0.05, 10, 17, 0.1, 8, 14},
                                                              {3, 3.5, 1.7, 10, 17, 8},
                                                              {17, 8, 0.05, 10, 0.1, 14}}};
        constexpr std::array<std::array<double, 6>, 4> centre{{{0.1312, 0.1696, 0.5569, 0.0124, 0.8283, 0.5886},
                                                               {0.2329, 0.4135, 0.8307, 0.3736, 0.1004, 0.9991},
                                                               {0.2348, 0.1451, 0.3522, 0.2883, 0.3047, 0.6650},
                                                               {0.4047, 0.8828, 0.8732, 0.5743, 0.1091, 0.0381}}};
        double sum = 0;
        for (std::size_t i = 0; i < 4; ++i) {
          double exponent = 0;
          for (std::size_t k = 0; k < 6; ++k) {
            exponent += width[i][k] * (x[k] - centre[i][k]) * (x[k] - centre[i][k]);
          }
          sum -= height[i] * std::exp(-exponent);
        }
        return cost(sum, {});
      }};
  for (int i = 1; i <= 6; ++i)
    problem.variables.push_back(real(std::string{"x"}.append(std::to_string(i)).c_str(), 0, 1));
  return problem;
}

}  // namespace

std::vector<BestProblem> best_problems() {
  return {{.name = "spring", .problem = spring(), .best = 0.012665},
          {.name = "vessel", .problem = vessel(), .best = 6059.714},
          {.name = "beam", .problem = beam(), .best = 1.724852},
          {.name = "reducer", .problem = reducer(), .best = 2994.471},
          {.name = "hartmann", .problem = hartmann(), .best = -3.32237}};
}

}  // namespace coilwright::sizing::testing
