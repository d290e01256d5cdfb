#include "coilwright/sizing/search/search.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <stdexcept>
#include <stop_token>

#include "coilwright/sizing/search/pareto.hpp"
#include "sizing/best_problems.hpp"
#include "sizing/expect_error.hpp"
#include "sizing/front_problems.hpp"

namespace coilwright::sizing {
namespace {

using testing::BestProblem;
using testing::expect_error;

Problem one_objective(Problem problem) {
  problem.objectives.resize(1);
  problem.evaluate = [inner = problem.evaluate](std::span<const double> x) {
    Evaluation evaluation = inner(x);
    if (evaluation.failure.empty()) evaluation.objectives.resize(1);
    return evaluation;
  };
  return problem;
}

TEST(Search, FindsThePublishedBestOfEngineeringProblems) {
  for (const BestProblem& problem : testing::best_problems()) {
    const SearchResult result =
        search(problem.problem, {.max_evaluations = 800, .seed = 2, .afterwards = Afterwards::nothing});
    ASSERT_TRUE(result.feasible) << problem.name;
    // 0.1 %: the published values carry four to seven digits
    EXPECT_NEAR(result.best->evaluation.objectives[0], problem.best, 1e-3 * std::abs(problem.best)) << problem.name;
  }
}

// Off the grid and beyond the bounds: the nearest legal design is the first, whatever searches.
TEST(Search, EvaluatesTheStartOfAProblemFirst) {
  Problem problem = one_objective(testing::winding_grid(testing::GridObjectives::two));
  problem.starts = {{2.2, 99, 7.6, 10, 2.9, 1.1}};
  for (const Algorithm algorithm : {Algorithm::automatic, Algorithm::cobyla, Algorithm::isres}) {
    const SearchResult result =
        search(problem, {.algorithm = algorithm, .max_evaluations = 40, .seed = 3, .afterwards = Afterwards::nothing});
    const std::vector<Record> records = result.archive.records();
    EXPECT_LE(records.size(), 40U);
    const auto first = std::ranges::find(records, 1U, &Record::number);
    ASSERT_NE(first, records.end());
    EXPECT_EQ(first->point, (std::vector<double>{2, 37, 8, 10, 3, 1})) << name_of(algorithm);
  }
  problem.starts.front().pop_back();
  expect_error<std::invalid_argument>([&] { (void)search(problem, {}); }, "start: must have 6 values; got 5");
}

// A unit square whose one good design, 1e-7 wide, no search finds.
Problem needle(std::size_t objectives) {
  Problem problem;
  problem.variables = {{.name = "x", .lower = 0, .upper = 1}, {.name = "y", .lower = 0, .upper = 1}};
  problem.objectives = {{.name = "f"}, {.name = "g"}};
  problem.objectives.resize(objectives);
  problem.evaluate = [objectives](std::span<const double> x) {
    const bool hit = std::abs(x[0] - 0.62) < 1e-7 && std::abs(x[1] - 0.17) < 1e-7;
    Evaluation out{.objectives = hit ? std::vector{-1.0, -1.0} : std::vector{x[0], x[1]}};
    out.objectives.resize(objectives);
    return out;
  };
  return problem;
}

TEST(Search, AnswersWithAStartThatNothingBeats) {
  Problem problem = needle(1);
  for (const Algorithm algorithm : algorithms()) {
    const SearchOptions options{
        .algorithm = algorithm, .max_evaluations = 60, .seed = 3, .afterwards = Afterwards::nothing};
    problem.starts.clear();
    EXPECT_GE(search(problem, options).best->evaluation.objectives[0], 0.0) << name_of(algorithm);
    problem.starts = {{0.5, 0.5}, {0.62, 0.17}};
    const SearchResult result = search(problem, options);
    EXPECT_EQ(result.best->evaluation.objectives[0], -1.0) << name_of(algorithm);
    EXPECT_LE(result.search_evaluations, 60U) << name_of(algorithm);
  }
}

TEST(Pareto, HasAStartThatNothingBeatsInItsFront) {
  Problem problem = needle(2);
  EXPECT_GT(pareto(problem, {.max_evaluations = 60, .seed = 3}).front.front().evaluation.objectives[0], -1.0);
  problem.starts = {{0.5, 0.5}, {0.62, 0.17}};
  const ParetoResult result = pareto(problem, {.max_evaluations = 60, .seed = 3});
  ASSERT_EQ(result.front.size(), 1U);
  EXPECT_EQ(result.front[0].point, problem.starts[1]);
  EXPECT_EQ(result.front[0].proposed_by, "start");
}

TEST(Search, EvaluatesStartsInTheirOrderEachOnceAndWithinTheBudget) {
  Problem problem = needle(1);
  problem.starts = {{0.9, 2.0}, {0.1, 0.2}, {0.9, 1.0}, {0.3, 0.4}};
  for (const std::size_t budget : {1U, 2U, 30U}) {
    const SearchResult result =
        search(problem, {.max_evaluations = budget, .seed = 3, .afterwards = Afterwards::nothing});
    std::vector<Record> records = result.archive.records();
    EXPECT_EQ(records.size(), budget);
    std::ranges::sort(records, {}, &Record::number);
    const std::vector<std::vector<double>> expected{{0.9, 1.0}, {0.1, 0.2}, {0.3, 0.4}};
    for (std::size_t i = 0; i < records.size(); ++i) {
      EXPECT_EQ(records[i].proposed_by == "start", i < 3) << i;
      if (i < 3) {
        EXPECT_EQ(records[i].point, expected[i]);
      }
    }
  }
}

TEST(Search, NumbersEveryEvaluationOnce) {
  const Problem problem = one_objective(testing::winding_grid(testing::GridObjectives::two));
  for (const Algorithm algorithm : {Algorithm::automatic, Algorithm::cobyla}) {
    const SearchResult result = search(problem, {.algorithm = algorithm, .max_evaluations = 150, .seed = 3});
    std::vector<std::size_t> numbers;
    for (const Record& record : result.archive.records()) numbers.push_back(record.number);
    std::ranges::sort(numbers);
    for (std::size_t i = 0; i < numbers.size(); ++i) EXPECT_EQ(numbers[i], i + 1) << name_of(algorithm);
  }
}

TEST(Search, FindsTheBestOfAllDesignsOfAGrid) {
  const Problem problem = one_objective(testing::winding_grid(testing::GridObjectives::two));
  double best = 0;
  for (const Objectives& values : testing::enumerate_feasible(problem)) best = std::max(best, -values[0]);
  const SearchResult result = search(problem, {.max_evaluations = 800, .seed = 4, .afterwards = Afterwards::nothing});
  EXPECT_EQ(result.best->evaluation.objectives[0], best);
}

// A budget for all designs lists them in the order of the grid, and whoever interrupts that has seen a corner.
TEST(Search, FindsAsEarlyWithALargeBudgetAsWithASmallOne) {
  const Problem problem = one_objective(testing::winding_grid(testing::GridObjectives::two));
  double best = 0;
  for (const Objectives& values : testing::enumerate_feasible(problem)) best = std::max(best, -values[0]);
  std::stop_source source;
  const SearchResult result = search(problem, {.max_evaluations = 100'000'000,
                                               .seed = 4,
                                               .afterwards = Afterwards::nothing,
                                               .stop = source.get_token(),
                                               .progress = [&](const Progress& progress) {
                                                 if (progress.evaluations >= 800) source.request_stop();
                                               }});
  EXPECT_EQ(result.stop_reason, StopReason::interrupted);
  EXPECT_LT(result.search_evaluations, 900U);
  EXPECT_EQ(result.best->evaluation.objectives[0], best);
}

TEST(Search, AnswersWithAFeasibleDesignFromItsArchiveWithEveryAlgorithm) {
  const Problem problem = one_objective(testing::winding_grid(testing::GridObjectives::two));
  for (const Algorithm algorithm : algorithms()) {
    const SearchResult result =
        search(problem, {.algorithm = algorithm, .max_evaluations = 500, .seed = 1, .afterwards = Afterwards::nothing});
    ASSERT_TRUE(result.feasible) << name_of(algorithm);
    EXPECT_TRUE(is_feasible(problem.evaluate(result.best->point))) << name_of(algorithm);
    EXPECT_EQ(result.archive.find(result.best->point), result.best->evaluation) << name_of(algorithm);
    EXPECT_LE(result.search_evaluations, 500U) << name_of(algorithm);
  }
}

TEST(Search, GivesTheSameArchiveOnAnyNumberOfThreads) {
  const Problem problem = one_objective(testing::winding_grid(testing::GridObjectives::two));
  for (const Algorithm algorithm : {Algorithm::automatic, Algorithm::cobyla, Algorithm::crs2, Algorithm::isres}) {
    const SearchOptions one{.algorithm = algorithm, .max_evaluations = 300, .seed = 9, .threads = 1};
    SearchOptions four = one;
    four.threads = 4;
    EXPECT_EQ(search(problem, one).archive.records(), search(problem, four).archive.records()) << name_of(algorithm);
  }
}

TEST(Search, OnlyEvaluatesWholeNumbersAndGridValues) {
  std::atomic<std::size_t> calls = 0;
  Problem problem = one_objective(testing::winding_grid(testing::GridObjectives::two));
  problem.evaluate = [&calls, inner = problem.evaluate](std::span<const double> x) {
    ++calls;
    for (std::size_t i = 0; i < 4; ++i) {
      if (x[i] != std::floor(x[i])) throw std::logic_error("not whole");
    }
    return inner(x);
  };
  for (const Algorithm algorithm : {Algorithm::automatic, Algorithm::slsqp, Algorithm::bobyqa}) {
    calls = 0;
    const SearchResult result = search(problem, {.algorithm = algorithm, .max_evaluations = 300, .seed = 9});
    EXPECT_EQ(calls, result.archive.size());
    EXPECT_EQ(result.archive.size(), result.search_evaluations + result.sensitivity_evaluations);
  }
}

// x in [-2, 3], one variable; the best of (x - 0.7)^2 with x >= 1.25 is at the limit.
Problem line(double lower = -2, double upper = 3) {
  return {.variables = {{.name = "x", .kind = VariableKind::continuous, .lower = lower, .upper = upper, .step = 0}},
          .objectives = {{.name = "f", .sense = Sense::minimise}},
          .constraints = {"reach"},
          .evaluate = [](std::span<const double> x) {
            return Evaluation{.objectives = {(x[0] - 0.7) * (x[0] - 0.7)},
                              .constraints = {1.25 - x[0]},
                              .failure = {},
                              .infeasibility = 0};
          }};
}

TEST(Search, WorksInOneVariableWithEveryAlgorithm) {
  for (const Algorithm algorithm : algorithms()) {
    const SearchResult result =
        search(line(), {.algorithm = algorithm, .max_evaluations = 300, .seed = 1, .afterwards = Afterwards::nothing});
    ASSERT_TRUE(result.feasible) << name_of(algorithm);
    // ESCH, which mutates at random, is within 0.02 of the range after 300 designs
    EXPECT_NEAR(result.best->point[0], 1.25, algorithm == Algorithm::esch ? 0.1 : 0.01) << name_of(algorithm);
  }
}

TEST(Search, KeepsVariablesWithEqualBoundsWhereTheyAre) {
  Problem problem = testing::best_problems()[4].problem;  // Hartmann
  problem.variables[2].lower = problem.variables[2].upper = 0.45;
  for (const Algorithm algorithm : {Algorithm::automatic, Algorithm::bobyqa}) {
    const SearchResult result = search(problem, {.algorithm = algorithm, .max_evaluations = 200, .seed = 1});
    for (const Record& record : result.archive.records()) ASSERT_EQ(record.point[2], 0.45);
  }
  const SearchResult fixed = search(line(1.5, 1.5), {.max_evaluations = 50, .seed = 1});
  EXPECT_EQ(fixed.archive.size(), 1U);
  EXPECT_EQ(fixed.stop_reason, StopReason::space_exhausted);
  EXPECT_TRUE(fixed.feasible);
}

TEST(Search, AnswersWithTheLeastInfeasibleDesignIfThereIsNoOther) {
  for (const Algorithm algorithm : algorithms()) {
    const SearchResult result = search(line(-2, 1), {.algorithm = algorithm, .max_evaluations = 200, .seed = 1});
    EXPECT_FALSE(result.feasible) << name_of(algorithm);
    EXPECT_EQ(result.violated, std::vector<std::string>{"reach"});
    // the end of the range; the evolution strategies, which only mutate, within 0.02 of it
    const bool evolution = algorithm == Algorithm::esch || algorithm == Algorithm::isres;
    EXPECT_NEAR(result.best->point[0], 1.0, evolution ? 0.06 : 0.01) << name_of(algorithm);
    EXPECT_TRUE(result.sensitivity.steps.empty());
  }
}

TEST(Search, RecordsANumberThatIsNotFiniteAsAFailureAndGoesOn) {
  Problem problem = line();
  problem.evaluate = [inner = problem.evaluate](std::span<const double> x) {
    Evaluation evaluation = inner(x);
    if (x[0] > 2) evaluation.objectives[0] = std::nan("");
    return evaluation;
  };
  for (const Algorithm algorithm : algorithms()) {
    const SearchResult result = search(problem, {.algorithm = algorithm, .max_evaluations = 300, .seed = 1});
    ASSERT_TRUE(result.feasible);
    EXPECT_TRUE(std::isfinite(result.best->evaluation.objectives[0]));
    for (const Record& record : result.archive.records()) {
      EXPECT_EQ(record.evaluation.failure, record.point[0] > 2 ? "objective 'f' is not finite (nan)" : "");
    }
  }
}

TEST(Search, HandsOnWhatTheProblemThrowsFromEveryAlgorithm) {
  Problem problem = one_objective(testing::bnh());
  problem.evaluate = [inner = problem.evaluate](std::span<const double> x) {
    if (x[0] + x[1] < 1.5) throw std::runtime_error("too small");
    return inner(x);
  };
  for (const Algorithm algorithm : algorithms()) {
    expect_error<std::runtime_error>(
        [&] { (void)search(problem, {.algorithm = algorithm, .max_evaluations = 2000, .seed = 1}); }, "too small");
  }
}

TEST(Search, ReturnsWhatItHasWhenInterrupted) {
  for (const Algorithm algorithm : {Algorithm::automatic, Algorithm::cobyla, Algorithm::isres}) {
    std::stop_source source;
    std::atomic<int> calls = 0;
    Problem problem = one_objective(testing::srn());
    problem.evaluate = [&, inner = problem.evaluate](std::span<const double> x) {
      if (++calls == 60) source.request_stop();
      return inner(x);
    };
    const SearchResult result =
        search(problem, {.algorithm = algorithm, .max_evaluations = 3000, .seed = 1, .stop = source.get_token()});
    EXPECT_EQ(result.stop_reason, StopReason::interrupted) << name_of(algorithm);
    EXPECT_EQ(result.search_stop_reason, StopReason::interrupted) << name_of(algorithm);
    EXPECT_TRUE(result.best.has_value());
    EXPECT_LT(result.archive.size(), 80U) << name_of(algorithm);
  }
}

TEST(Search, TellsWhyItEndedWhereItsSurroundingsAreInterrupted) {
  std::stop_source source;
  std::atomic<int> calls = 0;
  Problem problem = one_objective(testing::srn());
  problem.evaluate = [&, inner = problem.evaluate](std::span<const double> x) {
    if (++calls == 61) source.request_stop();
    return inner(x);
  };
  const SearchResult result = search(problem, {.max_evaluations = 60, .seed = 1, .stop = source.get_token()});
  ASSERT_TRUE(result.feasible);
  EXPECT_EQ(result.stop_reason, StopReason::interrupted);
  EXPECT_NE(result.search_stop_reason, StopReason::interrupted);
}

TEST(Search, TellsHowFarItIs) {
  std::vector<std::size_t> seen;
  const SearchResult result = search(one_objective(testing::srn()),
                                     {.max_evaluations = 300, .seed = 1, .progress = [&](const Progress& progress) {
                                        EXPECT_EQ(progress.max_evaluations, 300U);
                                        EXPECT_LE(progress.feasible, progress.evaluations);
                                        seen.push_back(progress.evaluations);
                                      }});
  EXPECT_TRUE(std::ranges::is_sorted(seen));
  EXPECT_EQ(seen.back(), result.search_evaluations);
}

TEST(Search, RejectsProblemsWithSeveralObjectives) {
  expect_error<std::invalid_argument>([] { (void)search(testing::bnh(), {}); },
                                      "objectives: must be one for a search (pareto takes two or three); got 2");
  expect_error<std::invalid_argument>([] { (void)search(line(), {.max_evaluations = 0}); },
                                      "max_evaluations: must be >= 1; got 0");
}

}  // namespace
}  // namespace coilwright::sizing
