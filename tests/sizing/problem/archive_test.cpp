#include "coilwright/sizing/problem/archive.hpp"

#include <atomic>
#include <stdexcept>
#include <thread>

#include "sizing/expect_error.hpp"

namespace coilwright::sizing {
namespace {

using testing::expect_error;

Problem counted(std::atomic<int>& calls) {
  return {
      .variables = {{.name = "x", .kind = VariableKind::continuous, .lower = -2, .upper = 6, .step = 0.1},
                    {.name = "y", .kind = VariableKind::continuous, .lower = 1, .upper = 4, .step = 0}},
      .objectives = {{.name = "f", .sense = Sense::minimise}, {.name = "g", .sense = Sense::maximise}},
      .constraints = {"limit"},
      .evaluate = [&calls](std::span<const double> x) {
        ++calls;
        if (x[1] > 3.5) {
          return Evaluation{.objectives = {}, .constraints = {}, .failure = "too long", .infeasibility = x[1] - 3.5};
        }
        return Evaluation{
            .objectives = {x[0] * x[0], x[0] + x[1]}, .constraints = {x[0] - 2.55}, .failure = {}, .infeasibility = 0};
      }};
}

TEST(Archive, EvaluatesADesignOnceHoweverItsGridValueWasComputed) {
  std::atomic<int> calls = 0;
  Archive archive{counted(calls)};
  const Evaluation first = archive.evaluate(std::vector<double>{-2 + 3 * 0.1, 1.75});
  EXPECT_EQ(archive.evaluate(std::vector<double>{-1.7, 1.75}), first);
  EXPECT_EQ(calls, 1);
  EXPECT_EQ(archive.size(), 1U);
  EXPECT_TRUE(archive.find(std::vector<double>{-1.7, 1.75}).has_value());
  EXPECT_FALSE(archive.find(std::vector<double>{-1.6, 1.75}).has_value());
}

// y has a range of 3 and no grid: rounding makes one design of both, a thousandth of a millionth two.
TEST(Archive, EvaluatesADesignOnceHoweverItsContinuousValueWasRounded) {
  std::atomic<int> calls = 0;
  Archive archive{counted(calls)};
  const Evaluation first = archive.evaluate(std::vector<double>{-1.5, 1.75});
  for (const double y : {1.75 + 3e-15, 1.75 - 3e-15, 1.75 + 4e-13})
    EXPECT_EQ(archive.evaluate(std::vector<double>{-1.5, y}), first);
  EXPECT_EQ(calls, 1);
  EXPECT_EQ(archive.evaluate(std::vector<double>{-1.5, 1.75 + 1e-9}).failure, "");
  EXPECT_EQ(calls, 2);
  EXPECT_EQ(archive.evaluate(std::vector<double>{-1.5, 1.0}), archive.evaluate(std::vector<double>{-1.5, 1 + 1e-15}));
  (void)archive.evaluate(std::vector<double>{-1.5, 4.0});
  EXPECT_EQ(archive.records().back().point[1], 4.0);  // the ends of a range are exact
  EXPECT_EQ(calls, 4);
}

// What is dear to call, as an interpreter, is called once for all new designs of a round; those that differ by rounding
// are one.
TEST(Archive, EvaluatesNewDesignsTogetherInOneCall) {
  std::atomic<int> calls = 0;
  Problem problem = counted(calls);
  std::vector<std::size_t> sizes;
  problem.evaluate_together = [&sizes, alone = problem.evaluate](std::span<const std::vector<double>> points) {
    sizes.push_back(points.size());
    std::vector<Evaluation> out;
    for (const std::vector<double>& point : points) out.push_back(alone(point));
    return out;
  };
  Archive archive{problem};
  const Evaluation known = archive.evaluate(std::vector<double>{0, 2});
  archive.evaluate_together(std::vector<std::vector<double>>{{0, 2}, {1, 2}, {1, 2}, {-2 + 3 * 0.1, 2}, {-1.7, 2}});
  EXPECT_EQ(sizes, std::vector<std::size_t>{2});
  EXPECT_EQ(archive.size(), 3U);
  EXPECT_EQ(archive.evaluate(std::vector<double>{0, 2}), known);
  EXPECT_EQ(archive.evaluate(std::vector<double>{-1.7, 2}), problem.evaluate(std::vector<double>{-1.7, 2}));
  EXPECT_EQ(calls, 4);
}

TEST(Archive, RefusesAnotherNumberOfEvaluationsThanOfDesigns) {
  std::atomic<int> calls = 0;
  Problem problem = counted(calls);
  problem.evaluate_together = [](std::span<const std::vector<double>>) { return std::vector<Evaluation>(1); };
  Archive archive{problem};
  expect_error<std::logic_error>(
      [&] {
        archive.evaluate_together(std::vector<std::vector<double>>{{0, 2}, {1, 2}});
      },
      "evaluate_together: must return 2 evaluations; got 1");
}

TEST(Archive, NumbersDesignsOnceInTheOrderItsCallerGives) {
  std::atomic<int> calls = 0;
  Archive archive{counted(calls)};
  const std::vector<double> a{0, 2}, b{1, 2}, c{2, 2};
  for (const auto& point : {a, b, c}) (void)archive.evaluate(point);
  for (const auto& point : {c, a, c, std::vector<double>{3, 2}}) archive.number(point);
  std::vector<std::size_t> numbers;
  for (const Record& record : archive.records()) numbers.push_back(record.number);
  EXPECT_EQ(numbers, (std::vector<std::size_t>{2, 0, 1}));
}

TEST(Archive, EvaluatesOnceWhenManyThreadsAskAtTheSameTime) {
  std::atomic<int> calls = 0;
  Archive archive{counted(calls)};
  {
    std::vector<std::jthread> threads;
    for (int t = 0; t < 4; ++t) {
      threads.emplace_back([&] {
        for (int i = 0; i < 50; ++i) archive.evaluate(std::vector<double>{-2 + 0.1 * i, 1.25});
      });
    }
  }
  EXPECT_EQ(calls, 50);
  EXPECT_EQ(archive.size(), 50U);
}

TEST(Archive, ListsDesignsInTheSameOrderWhateverTheOrderTheyCameIn) {
  std::atomic<int> calls = 0;
  const std::vector<std::vector<double>> points{{2.5, 3.75}, {-1.5, 2}, {2.5, 1.5}, {0.5, 3}};
  Archive forward{counted(calls)}, backward{counted(calls)};
  for (auto it = points.begin(); it != points.end(); ++it) forward.evaluate(*it);
  for (auto it = points.rbegin(); it != points.rend(); ++it) backward.evaluate(*it);
  EXPECT_EQ(forward.records(), backward.records());
  EXPECT_EQ(forward.front(), backward.front());
  EXPECT_EQ(forward.records().front().point, (std::vector<double>{-1.5, 2}));
  EXPECT_EQ(forward.records().back().evaluation.failure, "too long");
}

TEST(Archive, KeepsOnTheFrontOnlyFeasibleDesignsInTheirOwnSense) {
  std::atomic<int> calls = 0;
  Archive archive{counted(calls)};
  for (const auto& point : std::vector<std::vector<double>>{{0.5, 3}, {0.5, 2}, {2.4, 3.25}, {3.5, 3}, {0.4, 3.75}}) {
    archive.evaluate(point);
  }
  const std::vector<Record> front = archive.front();
  ASSERT_EQ(front.size(), 2U);
  EXPECT_EQ(front[0].point[1], 3.0);   // (0.25, 3.5) beats (0.25, 2.5)
  EXPECT_EQ(front[1].point[1], 3.25);  // (5.76, 5.65)
}

TEST(Archive, RanksFailedDesignsBehindThoseThatCouldBeEvaluated) {
  std::atomic<int> calls = 0;
  Archive archive{counted(calls)};
  EXPECT_FALSE(archive.least_infeasible().has_value());
  archive.evaluate(std::vector<double>{0.5, 3.6});
  EXPECT_EQ(archive.least_infeasible()->evaluation.failure, "too long");
  archive.evaluate(std::vector<double>{5.5, 3});
  EXPECT_EQ(archive.least_infeasible()->point[0], 5.5);
  EXPECT_FALSE(archive.best_feasible().has_value());
}

TEST(Archive, RecordsNothingWhenTheProblemThrows) {
  std::atomic<int> calls = 0;
  Problem problem = counted(calls);
  problem.evaluate = [inner = problem.evaluate, &calls](std::span<const double> x) {
    if (calls == 0) {
      ++calls;
      throw std::runtime_error("out of paper");
    }
    return inner(x);
  };
  Archive archive{std::move(problem)};
  const std::vector<double> point{0.5, 1.5};
  expect_error<std::runtime_error>([&] { archive.evaluate(point); }, "out of paper");
  EXPECT_EQ(archive.size(), 0U);
  EXPECT_TRUE(archive.evaluate(point).failure.empty());
  EXPECT_EQ(archive.size(), 1U);
}

TEST(Archive, RejectsPointsThatAreNoDesigns) {
  std::atomic<int> calls = 0;
  Archive archive{counted(calls)};
  expect_error<std::invalid_argument>([&] { archive.evaluate(std::vector<double>{0.5}); },
                                      "point: must have 2 values; got 1");
  expect_error<std::invalid_argument>(
      [&] {
        archive.evaluate(std::vector<double>{0.55, 2});
      },
      "point: variable 'x' must lie in [-2, 6] on the grid of step 0.1; got 0.55");
  expect_error<std::invalid_argument>(
      [&] {
        archive.evaluate(std::vector<double>{0.5, 4.25});
      },
      "point: variable 'y' must lie in [1, 4]; got 4.25");
}

}  // namespace
}  // namespace coilwright::sizing
