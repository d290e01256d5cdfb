#include "measurement/identification/insensitive_parameters.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "measurement/random_numbers.hpp"
#include "measurement/slider_model.hpp"

namespace coilwright::measurement::identification {
namespace {

// The slide, fitted from a wall there. Its motion never goes below 0, where it begins.
struct Fitted {
  explicit Fitted(double wall) : declared(slide_with_wall(true_mass, true_damping, declared_wall)) {
    declared.calibration.back().other_start = -1.0;
    Normal normal(11);
    run = slide_run(300, {}, [&] { return noise_sigma * normal(); });
    const fit::Hypothesis hypothesis(declared, {});
    runs.push_back(replay::prepare_run(run, declared, hypothesis.model_at(hypothesis.start())));
    Eigen::VectorXd start = hypothesis.start();
    start[2] = wall;
    auto found = fit::fit({.hypothesis = &hypothesis, .runs = runs, .start = start});
    EXPECT_TRUE(found.has_value());
    fitted.emplace_back(score(runs, hypothesis, std::move(*found)));
  }
  [[nodiscard]] std::vector<InsensitiveParameter> idle() const { return insensitive_parameters(runs, fitted.front()); }

  static constexpr double declared_wall = 0.3;
  replay::DeclaredModel declared;
  data::Run run;
  std::vector<replay::PreparedRun> runs{};
  std::vector<FittedHypothesis> fitted{};
};

TEST(IdleNumbers, ReachToWhereTheMotionBegins) {
  const Fitted at_nowhere(-1.0);
  const std::vector<InsensitiveParameter> idle = at_nowhere.idle();
  ASSERT_EQ(idle.size(), 1u);
  EXPECT_EQ(idle[0].index, 2);
  EXPECT_NEAR(idle[0].nearest, 0.0, 0.002);  // noise of 0.001, the wall presses by as much unseen
  // The prior counts three tolerances, a person the six from 0.3 to 0.
  EXPECT_NEAR(probability_of_declared_numbers(at_nowhere.fitted.front()), 0.0027, 1e-4);
  EXPECT_LT(probability_of_declared_numbers(at_nowhere.fitted.front(), idle), 1e-8);
}

TEST(IdleNumbers, AreNotThoseThatAPriorStillPulls) {
  Fitted near(-1.0);
  near.fitted.front().fit.values[2] = Fitted::declared_wall - 0.1;  // two tolerances
  EXPECT_TRUE(near.idle().empty());
}

}  // namespace
}  // namespace coilwright::measurement::identification
