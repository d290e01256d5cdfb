#include "measurement/identification/reached_limits.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "measurement/identification/recalibration.hpp"
#include "measurement/random_numbers.hpp"
#include "measurement/slider_model.hpp"

namespace coilwright::measurement::identification {
namespace {

// A slide that is drawn below 0, where it begins, and runs into a wall there, recorded with noise; `declared` has the
// wall elsewhere, within 0.05.
struct Recorded {
  Recorded(double true_wall, double declared_wall)
      : truth(slide_with_wall(true_mass, true_damping, true_wall)),
        declared(slide_with_wall(1.1 * true_mass, 0.9 * true_damping, declared_wall)) {
    declared.calibration.back().other_start = -1.0;
    const fit::Hypothesis as_is(truth, {});
    run = slide_run(300, {}, no_error);
    for (std::vector<double>& input : run.inputs) input[0] = -input[0];
    std::vector<replay::PreparedRun> plain{replay::prepare_run(run, truth, as_is.model_at(as_is.start()))};
    const auto motion = fit::evaluate_at({.hypothesis = &as_is, .runs = plain, .start = as_is.start()});
    EXPECT_TRUE(motion.has_value());
    Normal normal(23);
    for (std::size_t i = 0; i < run.samples(); ++i)
      run.channels[0].values[i] = motion->runs[0].predictions[static_cast<Eigen::Index>(i)] + noise_sigma * normal();
    const fit::Hypothesis hypothesis(declared, {});
    runs.push_back(replay::prepare_run(run, declared, hypothesis.model_at(hypothesis.start())));
    runs.back().simulations = std::make_shared<std::atomic<long>>();
  }
  // Fitted with the wall held there.
  [[nodiscard]] FittedHypothesis fitted_at(double wall) const {
    const fit::Hypothesis hypothesis(declared, {});
    Eigen::VectorXd start = hypothesis.start();
    start[2] = wall;
    auto found = fit::fit({.hypothesis = &hypothesis, .runs = runs, .start = start, .held_parameter = 2});
    EXPECT_TRUE(found.has_value());
    return score(runs, hypothesis, std::move(*found));
  }

  replay::DeclaredModel truth;
  replay::DeclaredModel declared;
  data::Run run;
  std::vector<replay::PreparedRun> runs{};
};

TEST(ReachedLimits, LeadBackFromAWallThatIsNowhere) {
  const Recorded recorded(-0.05, -0.2);
  const FittedHypothesis nowhere = recorded.fitted_at(-1.0);
  EXPECT_EQ(nowhere.fit.values[2], -1.0);
  EXPECT_GT(nowhere.whiteness.level, 3.0);
  recorded.runs.front().simulations->store(0);
  const auto plans = from_reached_limits(recorded.runs, nowhere);
  ASSERT_FALSE(plans.empty());
  ASSERT_LE(plans.size(), 3u);
  EXPECT_GT(recorded.runs.front().simulations->load(), 20);
  const PlannedFit& lowest = plans.front();
  EXPECT_NE(lowest.start[2], -1.0);
  EXPECT_EQ(lowest.start.head(2), nowhere.fit.values.head(2));
  // Wherever that is, with the other numbers bent by the wall that is missing: it is found from there.
  const auto again = fit_exactly(recorded.runs, lowest);
  ASSERT_TRUE(again.has_value());
  EXPECT_NEAR(again->fit.values[2], -0.05, 0.002);
  EXPECT_NEAR(again->whiteness.level, 1.0, 0.15);
  EXPECT_TRUE(from_reached_limits(recorded.runs, *again).empty());
}

TEST(ReachedLimits, AreThoseOfNumbersWithAnotherStartOnly) {
  Recorded recorded(-0.05, -0.2);
  recorded.declared.calibration.back().other_start.reset();
  const FittedHypothesis fitted = recorded.fitted_at(-0.3);
  recorded.runs.front().simulations->store(0);
  const auto plans = from_reached_limits(recorded.runs, fitted);
  EXPECT_TRUE(plans.empty());
  EXPECT_EQ(recorded.runs.front().simulations->load(), 0);
}

TEST(Recalibration, FindsAWallThatIsFarFromWhereItIsDeclared) {
  for (const double declared_wall : {-0.3, 0.1}) {
    const Recorded recorded(-0.05, declared_wall);
    const auto found = recalibrated(recorded.runs, recorded.declared);
    EXPECT_NEAR(found.fit.values[2], -0.05, 0.002) << declared_wall;
    EXPECT_NEAR(found.whiteness.level, 1.0, 0.15) << declared_wall;
  }
}

}  // namespace
}  // namespace coilwright::measurement::identification
