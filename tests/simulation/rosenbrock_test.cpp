#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdio>
#include <numeric>
#include <utility>
#include <vector>

#include "simulation/rosenbrock_step.hpp"

namespace coilwright::simulation {
namespace {

constexpr int stages = RosenbrockMethod::stages;
using StageMatrix = Eigen::Matrix<double, stages, stages>;
using StageVector = Eigen::Matrix<double, stages, 1>;

// A rooted tree, by its children.
struct Tree {
  std::vector<Tree> children;

  [[nodiscard]] int order() const {
    return std::accumulate(children.begin(), children.end(), 1,
                           [](int sum, const Tree& child) { return sum + child.order(); });
  }
  [[nodiscard]] double density() const {
    return std::accumulate(children.begin(), children.end(), 1.0 * order(),
                           [](double product, const Tree& child) { return product * child.density(); });
  }
};

void add_forests(int nodes, int largest, std::vector<Tree>& chosen, std::vector<Tree>& out);

std::vector<Tree> trees(int order) {
  std::vector<Tree> out;
  std::vector<Tree> chosen;
  add_forests(order - 1, order - 1, chosen, out);
  return out;
}

// Every choice of children with `nodes` nodes together, none larger than the one before it (nor, of one size, earlier).
void add_forests(int nodes, int largest, std::vector<Tree>& chosen, std::vector<Tree>& out) {
  if (nodes == 0) {
    out.push_back({chosen});
    return;
  }
  for (int size = std::min(nodes, largest); size >= 1; --size) {
    const std::vector<Tree> of_size = trees(size);
    for (const Tree& tree : of_size) {
      chosen.push_back(tree);
      add_forests(nodes - size, size, chosen, out);
      chosen.pop_back();
    }
  }
}

// The method as Hairer and Wanner define it (IV.7.4), back from the form that it is coded in.
struct Definition {
  StageMatrix alpha = StageMatrix::Zero();
  StageMatrix beta;
  StageVector weights;
  StageVector lower_weights;
};

Definition definition() {
  const RosenbrockMethod& m = RosenbrockStep::method;
  StageMatrix place = StageMatrix::Zero();
  StageMatrix carry = StageMatrix::Zero();
  for (int i = 1; i < stages; ++i) {
    for (int j = 0; j < i; ++j) carry(i, j) = m.carry[i][j];
    if (i < RosenbrockMethod::own_places) {
      for (int j = 0; j < i; ++j) place(i, j) = m.place[i][j];
    } else {
      place.row(i) = place.row(i - 1);
      place(i, i - 1) = 1.0;
    }
  }
  StageVector end = place.row(stages - 1).transpose();
  StageVector lower = end;
  end[stages - 1] = 1.0;
  const StageMatrix gammas = (StageMatrix::Identity() / m.gamma - carry).inverse();
  Definition out;
  out.alpha = place * gammas;
  out.beta = out.alpha + gammas;
  out.weights = gammas.transpose() * end;
  out.lower_weights = gammas.transpose() * lower;
  return out;
}

// Elementary weight of every stage: over a branch that goes on alone beta, over one beside others alpha.
StageVector weight(const Tree& tree, const Definition& method) {
  StageVector out = StageVector::Ones();
  const StageMatrix& across = tree.children.size() == 1 ? method.beta : method.alpha;
  for (const Tree& child : tree.children) out = out.cwiseProduct(across * weight(child, method));
  return out;
}

// Theorem IV.7.4 of Hairer and Wanner: order p where every tree of up to p nodes has the weight 1 / its density.
TEST(Rosenbrock, FulfilsTheConditionsOfItsOrder) {
  const Definition method = definition();
  int count = 0;
  for (int order = 1; order <= 5; ++order) {
    for (const Tree& tree : trees(order)) {
      ++count;
      // Coefficients of sixteen digits and up to 150 in size.
      EXPECT_NEAR(method.weights.dot(weight(tree, method)), 1.0 / tree.density(), 1e-12) << order;
      if (order <= 4) {
        EXPECT_NEAR(method.lower_weights.dot(weight(tree, method)), 1.0 / tree.density(), 1e-12) << order;
      }
    }
  }
  EXPECT_EQ(count, 17);
  double worst = 0.0;
  for (const Tree& tree : trees(6))
    worst = std::max(worst, std::abs(method.weights.dot(weight(tree, method)) - 1.0 / tree.density()));
  EXPECT_GT(worst, 1e-5);  // or the test sees nothing
}

// y' = lambda y: the growth over a step tends to nothing for stiff decay, and is never above 1 on the imaginary axis.
TEST(Rosenbrock, IsLStable) {
  const Definition method = definition();
  const auto growth = [&](std::complex<double> z) {
    const Eigen::MatrixXcd matrix = Eigen::MatrixXcd::Identity(stages, stages) - z * method.beta;
    return std::abs(1.0 + z * method.weights.cast<std::complex<double>>().dot(
                                  matrix.partialPivLu().solve(Eigen::VectorXcd::Ones(stages))));
  };
  EXPECT_LT(growth(-1e8), 1e-6);
  for (double frequency = 0.01; frequency < 1e5; frequency *= 1.1)
    EXPECT_LE(growth({0.0, frequency}), 1.0 + 1e-10) << frequency;
}

// q'' = q^3 - q q' has the solutions 1 / (c + t). Two of them, mixed, so that nothing is diagonal.
struct Mixed {
  Eigen::Matrix2d mix = (Eigen::Matrix2d() << 0.8, -0.3, 0.45, 1.1).finished();
  Eigen::Vector2d begin{0.7, 1.3};

  [[nodiscard]] MotionVector exact(double time) const {
    MotionVector out(4);
    const Eigen::Array2d q = 1.0 / (begin.array() + time);
    out << mix * q.matrix(), mix * (-q * q).matrix();
    return out;
  }
  [[nodiscard]] MotionVector derive(const MotionVector& at) const {
    const Eigen::Array2d q = mix.inverse() * at.head(2);
    const Eigen::Array2d rate = mix.inverse() * at.tail(2);
    MotionVector out(4);
    out << at.tail(2), mix * (q * q * q - q * rate).matrix();
    return out;
  }
  // Of M F, with a mass matrix that is neither symmetric nor near 1.
  [[nodiscard]] mechanics::ChainSlopes slopes(const MotionVector& at) const {
    const Eigen::Array2d q = mix.inverse() * at.head(2);
    const Eigen::Array2d rate = mix.inverse() * at.tail(2);
    const Eigen::Matrix2d mass = (Eigen::Matrix2d() << 3.0, 0.4, -0.2, 0.5).finished();
    return {.by_acceleration = mass,
            .by_rate = mass * mix * q.matrix().asDiagonal() * mix.inverse(),
            .by_angle = mass * mix * (rate - 3.0 * q * q).matrix().asDiagonal() * mix.inverse()};
  }
};

TEST(Rosenbrock, ErrsByItsOrderOnAProblemWithAKnownSolution) {
  const Mixed problem;
  const auto errors = [&](int steps) {
    const double step = 2.0 / steps;
    RosenbrockStep method;
    MotionVector at = problem.exact(0.0);
    double inside = 0.0;
    for (int i = 0; i < steps; ++i) {
      method.take(at, problem.derive(at), problem.slopes(at), step,
                  [&](const MotionVector& values) { return problem.derive(values); });
      // From the exact start, what the dense output alone adds in one step.
      inside = std::max(inside, (method.at(0.37) - problem.exact((i + 0.37) * step)).norm());
      at = method.end();
    }
    return std::pair((at - problem.exact(2.0)).norm(), inside);
  };
  auto [end, inside] = errors(64);
  for (const int steps : {128, 256}) {
    const auto [finer_end, finer_inside] = errors(steps);
    EXPECT_NEAR(std::log2(end / finer_end), 5.0, 0.5) << steps;
    EXPECT_GT(std::log2(inside / finer_inside), 4.0) << steps;
    end = finer_end;
    inside = finer_inside;
  }
  EXPECT_LT(end, 1e-10);
}

// Van der Pol's equation with a stiffness of a million. The solution at t = 2: Test Set for Initial Value Problem
// Solvers (Mazzia and Magherini, Bari), problem VDPOL, and Hairer and Wanner's own table: 15 digits.
TEST(Rosenbrock, SolvesAStiffProblemToItsPublishedSolution) {
  constexpr double epsilon = 1e-6;
  const auto derive = [](const MotionVector& at) {
    MotionVector out(2);
    out << at[1], ((1.0 - at[0] * at[0]) * at[1] - at[0]) / epsilon;
    return out;
  };
  const auto slopes = [](const MotionVector& at) {
    const auto one = [](double value) { return mechanics::JointMatrix::Constant(1, 1, value); };
    return mechanics::ChainSlopes{.by_acceleration = one(epsilon),
                                  .by_rate = one(at[0] * at[0] - 1.0),
                                  .by_angle = one(2.0 * at[0] * at[1] + 1.0)};
  };
  RosenbrockStep method;
  MotionVector at(2);
  at << 2.0, 0.0;
  double time = 0.0;
  double step = 1e-7;
  int tries = 0;
  while (time < 2.0 && ++tries < 20000) {
    step = std::min(step, 2.0 - time);
    method.take(at, derive(at), slopes(at), step, derive);
    const double error = (method.error().array() / (1e-8 * (1.0 + method.end().array().abs()))).abs().maxCoeff();
    if (error <= 1.0) {
      time += step;
      at = method.end();
    }
    step *= std::clamp(0.9 * std::pow(error, -0.2), 0.2, 5.0);
  }
  std::printf("  van der Pol: %d tries, off by %.1e and %.1e\n", tries, at[0] - 1.706167732170483,
              at[1] + 0.8928097010247975);
  EXPECT_NEAR(at[0], 1.706167732170483, 1e-6);  // a hundred times what a step may err by
  EXPECT_NEAR(at[1], -0.8928097010247975, 1e-6);
  EXPECT_LT(tries, 4000);  // an explicit method would need millions
}

}  // namespace
}  // namespace coilwright::simulation
