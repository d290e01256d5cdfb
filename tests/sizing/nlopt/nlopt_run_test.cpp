#include "sizing/nlopt/nlopt_run.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "sizing/expect_error.hpp"

namespace coilwright::sizing {
namespace {

std::vector<Algorithm> nlopt_algorithms() {
  std::vector<Algorithm> all = algorithms();
  std::erase(all, Algorithm::automatic);
  return all;
}

// (x - 0.3)^2 + 2 (y + 0.4)^2
NloptTask bowl(Algorithm algorithm) {
  return {.algorithm = algorithm,
          .lower = {-1, -2},
          .upper = {2, 1},
          .start = {1.5, 0.5},
          .objective =
              [](std::span<const double> x, std::span<double> gradient) {
                if (!gradient.empty()) {
                  gradient[0] = 2 * (x[0] - 0.3);
                  gradient[1] = 4 * (x[1] + 0.4);
                }
                return std::pow(x[0] - 0.3, 2) + 2 * std::pow(x[1] + 0.4, 2);
              },
          .max_calls = 3000,
          .relative_tolerance = 1e-6,
          .seed = 5};
}

TEST(NloptRun, FindsTheBottomOfABowlWithEveryAlgorithm) {
  for (const Algorithm algorithm : nlopt_algorithms()) {
    const std::vector<double> x = run_nlopt(bowl(algorithm));
    // The evolution strategies only mutate: about 0.01 after 3000 calls. The others converge to 1e-3 and better.
    const bool evolution = algorithm == Algorithm::esch || algorithm == Algorithm::isres;
    const double tolerance = evolution ? 0.05 : 1e-3;
    EXPECT_NEAR(x[0], 0.3, tolerance) << name_of(algorithm);
    EXPECT_NEAR(x[1], -0.4, tolerance) << name_of(algorithm);
  }
}

TEST(NloptRun, HandsOnWhatTheObjectiveThrowsWithEveryAlgorithm) {
  for (const Algorithm algorithm : nlopt_algorithms()) {
    NloptTask task = bowl(algorithm);
    int calls = 0, calls_after = 0;
    task.objective = [&, inner = task.objective](std::span<const double> x, std::span<double> gradient) {
      if (calls > 6) ++calls_after;
      if (++calls > 6) throw std::runtime_error("the seventh call");
      return inner(x, gradient);
    };
    testing::expect_error<std::runtime_error>([&] { (void)run_nlopt(task); }, "the seventh call");
    EXPECT_EQ(calls_after, 0) << name_of(algorithm);
  }
}

TEST(NloptRun, HandsOnWhatAConstraintThrows) {
  for (const Algorithm algorithm : nlopt_algorithms()) {
    if (!takes_constraints(algorithm)) continue;
    NloptTask task = bowl(algorithm);
    task.constraint_count = 2;
    task.constraints = [](std::span<const double>, std::span<double>, std::span<double>) {
      throw std::domain_error("no such coil");
    };
    testing::expect_error<std::domain_error>([&] { (void)run_nlopt(task); }, "no such coil");
  }
}

TEST(NloptRun, RepeatsBitForBitWithTheSameSeed) {
  for (const Algorithm algorithm : nlopt_algorithms()) {
    NloptTask task = bowl(algorithm);
    task.max_calls = 200;
    EXPECT_EQ(run_nlopt(task), run_nlopt(task)) << name_of(algorithm);
  }
}

}  // namespace
}  // namespace coilwright::sizing
