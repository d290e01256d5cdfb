#include "coilwright/sizing/study/sweep.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "coilwright/sizing/study/leaders.hpp"
#include "sizing/small_study.hpp"

namespace coilwright::sizing {
namespace {

using testing::small_study;

std::vector<SweptDesign> all_of(const DesignProblem& problem, unsigned threads) {
  std::vector<SweptDesign> designs;
  EXPECT_EQ(sweep(problem, {.threads = threads}, [&](const SweptDesign& design) { designs.push_back(design); }),
            problem.point_count());
  return designs;
}

// A study of many designs that are refused at once.
Study tight_bores() {
  Study study = small_study();
  study.variables = {ParameterVariable{.parameter = actuator::find_parameter("coil_inner_radius_mm"),
                                       .range = Interval{.lower = 0.1, .upper = 0.3, .step = 1e-4}}};
  return study;
}

TEST(Sweep, HandsOverEveryPointOnceAndInOrder) {
  const DesignProblem problem(small_study());
  const std::vector<SweptDesign> designs = all_of(problem, 2);
  ASSERT_EQ(designs.size(), 36u);
  for (std::size_t i = 0; i < designs.size(); ++i) {
    EXPECT_EQ(designs[i].index, i);
    EXPECT_EQ(designs[i].point, problem.point(i));
    EXPECT_EQ(designs[i].evaluation, problem.problem().evaluate(designs[i].point));
  }
}

// 30 designs: one in each thirtieth of a length, and of a variable with values as many of each as there are shares.
TEST(SampledPoints, FillTheRangeOfEveryVariableEvenly) {
  Study study = small_study();
  study.variables = {
      ParameterVariable{.parameter = actuator::find_parameter("gap_mm"), .range = Interval{.lower = 0.6, .upper = 1.8}},
      ParameterVariable{.parameter = actuator::find_parameter("turns_radial"),
                        .range = Choice{.values = {8.0, 10.0, 15.0}}}};
  const DesignProblem problem(study);
  const auto points = sampled_points(problem, {.drawn = 30, .seed = 4});
  ASSERT_EQ(points.size(), 30u);
  std::vector<int> of_gap(30);
  std::vector<int> of_turns(3);
  for (const std::vector<double>& point : points) {
    ++of_gap.at(static_cast<std::size_t>((point[0] - 0.6) / 1.2 * 30.0));
    ++of_turns.at(static_cast<std::size_t>(point[1]));
  }
  EXPECT_EQ(of_gap, std::vector<int>(30, 1));
  EXPECT_EQ(of_turns, std::vector<int>(3, 10));
  EXPECT_EQ(points, sampled_points(problem, {.drawn = 30, .seed = 4}));
  EXPECT_NE(points, sampled_points(problem, {.drawn = 30, .seed = 5}));
  // Designs drawn each by itself leave some of the shares empty.
  std::vector<int> at_random(30);
  for (const std::vector<double>& point :
       sampled_points(problem, {.sampling = Sampling::random, .drawn = 30, .seed = 4}))
    ++at_random.at(static_cast<std::size_t>((point[0] - 0.6) / 1.2 * 30.0));
  EXPECT_GT(std::ranges::count(at_random, 0), 3);
  std::size_t taken = 0;
  EXPECT_EQ(
      sweep(problem, {.points = points}, [&](const SweptDesign& d) { taken += d.point == points[d.index] ? 1 : 0; }),
      30u);
  EXPECT_EQ(taken, 30u);
}

TEST(SampledPoints, HaveADesignOfAGridOnce) {
  const DesignProblem problem(small_study());  // 36 designs
  for (const auto& [word, sampling] : sampling_words) {
    auto points = sampled_points(problem, {.sampling = sampling, .drawn = 400, .seed = 4});
    EXPECT_LE(points.size(), 36u) << word;
    EXPECT_GT(points.size(), 30u) << word;
    std::ranges::sort(points);
    EXPECT_EQ(std::ranges::adjacent_find(points), points.end()) << word;
    EXPECT_EQ(name_of(sampling), word);
  }
}

TEST(Sweep, GivesEveryQuantityOfADesign) {
  Study study = small_study();
  study.quantities = study.quantities.with(
      {.name = "grasp_force_per_mass_N_kg",
       .meaning = "grasp force divided by the mass of the actuator",
       .scale = 15.0,
       .value = [](const simulation::DesignView& d) { return d.performance.cold.grasp_force / d.performance.mass; }});
  const DesignProblem problem(study);
  const simulation::QuantityTable& quantities = problem.study().quantities;
  const SweptDesign design = all_of(problem, 1)[17];
  const auto evaluated = std::get<EvaluatedDesign>(problem.evaluate(design.point));
  ASSERT_EQ(design.evaluation.quantities.size(), quantities.size());
  for (std::size_t i = 0; i < quantities.size(); ++i)
    EXPECT_EQ(design.evaluation.quantities[i], quantities[i].value(evaluated.view())) << quantities[i].name;
}

TEST(Sweep, IsTheSameOnAnyNumberOfThreads) {
  const DesignProblem problem(tight_bores());
  const auto one = all_of(problem, 1), three = all_of(problem, 3);
  ASSERT_EQ(one.size(), 2001u);
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].point, three[i].point);
    EXPECT_EQ(one[i].evaluation, three[i].evaluation);
    EXPECT_TRUE(one[i].evaluation.quantities.empty());
  }
}

TEST(Sweep, EndsWithoutAGapWhenAskedTo) {
  const DesignProblem problem(tight_bores());
  std::stop_source stop;
  std::vector<std::size_t> taken;
  const std::size_t count = sweep(problem, {.threads = 2, .stop = stop.get_token()}, [&](const SweptDesign& design) {
    taken.push_back(design.index);
    if (design.index == 100) stop.request_stop();
  });
  EXPECT_EQ(count, taken.size());
  EXPECT_LT(count, problem.point_count());
  EXPECT_GT(count, 100u);
  for (std::size_t i = 0; i < taken.size(); ++i) EXPECT_EQ(taken[i], i);
}

TEST(Sweep, PassesOnWhatItsReceiverThrows) {
  const DesignProblem problem(tight_bores());
  EXPECT_THROW(sweep(problem, {}, [](const SweptDesign&) { throw std::runtime_error("disk full"); }),
               std::runtime_error);
}

TEST(Leaders, AreTheBestFeasibleOfEachConfigurationInEachObjective) {
  const DesignProblem problem(small_study());
  const std::vector<SweptDesign> designs = all_of(problem, 2);
  Leaders leaders(problem);
  for (const SweptDesign& design : designs) leaders.consider(design);
  ASSERT_TRUE(leaders.any_feasible());
  const std::vector<Leader> all = leaders.all();
  ASSERT_EQ(all.size(), 4u);
  EXPECT_EQ(all[0].configuration, "B");  // in the order of the study
  EXPECT_EQ(all[3].configuration, "A");
  for (const Leader& leader : all) {
    EXPECT_TRUE(is_feasible(leader.design.evaluation));
    for (const SweptDesign& rival : designs) {
      if (rival.point[0] != leader.design.point[0] || !is_feasible(rival.evaluation)) continue;
      const double difference =
          rival.evaluation.objectives[leader.objective] - leader.design.evaluation.objectives[leader.objective];
      EXPECT_LE(leader.objective == 0 ? difference : -difference, 0.0);  // speed up, mass down
    }
  }
}

TEST(Leaders, AreTheLeastInfeasibleWhereNothingIsFeasible) {
  Study study = small_study();
  study.limits[0].value = 52.0;  // too little for B, enough for A
  const DesignProblem problem(study);
  const std::vector<SweptDesign> designs = all_of(problem, 2);
  Leaders leaders(problem);
  for (const SweptDesign& design : designs) leaders.consider(design);
  const std::vector<Leader> all = leaders.all();
  ASSERT_EQ(all.size(), 3u);  // one entry for B, two for A
  EXPECT_EQ(all[0].configuration, "B");
  EXPECT_FALSE(is_feasible(all[0].design.evaluation));
  for (const SweptDesign& rival : designs) {
    if (rival.point[0] != 0.0) continue;
    EXPECT_LE(violation(all[0].design.evaluation), violation(rival.evaluation));
  }
}

TEST(Leaders, OfAStudyWithoutConfigurationsHaveNoLetter) {
  const DesignProblem problem(tight_bores());
  Leaders leaders(problem);
  for (const SweptDesign& design : all_of(problem, 1)) leaders.consider(design);
  ASSERT_EQ(leaders.all().size(), 1u);
  EXPECT_EQ(leaders.all()[0].configuration, "");
  EXPECT_EQ(leaders.all()[0].design.index, 2000u);  // the widest bore
  EXPECT_FALSE(leaders.any_feasible());
}

}  // namespace
}  // namespace coilwright::sizing
