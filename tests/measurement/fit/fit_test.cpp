#include "measurement/fit/fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "measurement/fit/update_derivatives.hpp"
#include "measurement/random_numbers.hpp"
#include "measurement/slider_model.hpp"

namespace coilwright::measurement::fit {
namespace {

using actuator::Effect;
using actuator::standard_effects;

struct Prepared {
  Prepared(const replay::DeclaredModel& declared, const data::Run& run, std::vector<Effect> effects = {})
      : hypothesis(declared, std::move(effects)) {
    const Hypothesis plain(declared, {});
    runs.push_back(replay::prepare_run(run, declared, plain.model_at(plain.start())));
    runs.back().simulations = std::make_shared<std::atomic<long>>();
  }
  // Since it was asked last.
  [[nodiscard]] long simulated_runs() const { return runs.front().simulations->exchange(0); }
  Hypothesis hypothesis;
  std::vector<replay::PreparedRun> runs;
};

Fit fitted(const Prepared& prepared) {
  auto found = fit({.hypothesis = &prepared.hypothesis, .runs = prepared.runs, .start = prepared.hypothesis.start()});
  EXPECT_TRUE(found.has_value());
  return found.value_or(Fit{});
}

TEST(Fit, RecoversMassAndDampingOfTheClosedForm) {
  const replay::DeclaredModel declared = slide(3.0, 1.0);  // 1.5 and a third times the true values
  const auto run = slide_run(300, {}, no_error);
  const Fit found = fitted(Prepared(declared, run));
  // The tolerance follows from the relative accuracy of the integrator, 1e-6.
  EXPECT_NEAR(found.values[0], true_mass, 1e-5 * true_mass);
  EXPECT_NEAR(found.values[1], true_damping, 1e-5 * true_damping);
  EXPECT_LT(found.chi_square, 1e-3);
  EXPECT_EQ(found.samples(), 300u);
}

TEST(Fit, ResidualsAreMeasuredMinusPredictedOverTheNoise) {
  const replay::DeclaredModel declared = slide(true_mass, true_damping);
  const auto run = slide_run(100, {}, [] { return 2.0 * noise_sigma; });
  const Prepared prepared(declared, run);
  const auto there =
      evaluate_at({.hypothesis = &prepared.hypothesis, .runs = prepared.runs, .start = prepared.hypothesis.start()});
  ASSERT_TRUE(there.has_value());
  for (const double residual : there->runs.front().residuals) EXPECT_NEAR(residual, 2.0, 1e-2);
  EXPECT_NEAR(there->chi_square, 400.0, 4.0);
}

// Of y = A x + (x1 + x2)^2 b, whose derivatives change as it goes: after each step they give that step's change.
TEST(UpdatedDerivatives, GiveTheChangeOfTheStep) {
  const Eigen::MatrixXd linear{{1.0, 2.0, 0.5}, {0.0, -1.0, 3.0}, {4.0, 1.0, 1.0}, {2.0, 2.0, -2.0}};
  const Eigen::Vector4d bend(0.5, -1.0, 2.0, 1.0);
  const auto values = [&](const Eigen::Vector3d& x) -> Eigen::VectorXd {
    return linear * x + (x[0] + x[1]) * (x[0] + x[1]) * bend;
  };
  Eigen::Vector3d at(0.1, -0.2, 0.3);
  ResidualValues::Block block{.residuals = values(at)};
  block.jacobian = linear.leftCols(2) + 2.0 * (at[0] + at[1]) * bend * Eigen::RowVector2d::Ones();
  block.local_jacobian = linear.col(2);
  for (const Eigen::Vector3d& step : {Eigen::Vector3d(0.5, 0.1, -0.2), Eigen::Vector3d(0.0, 0.3, 0.1)}) {
    const Eigen::VectorXd before = block.residuals;
    at += step;
    block.residuals = values(at);
    update_derivatives({.parameters = step.head(2),
                        .parameter_scales = Eigen::Vector2d(0.1, 10.0),
                        .local = step.tail(1),
                        .local_scales = Eigen::VectorXd::Constant(1, 2.0)},
                       before, block);
    const Eigen::VectorXd shown = block.jacobian * step.head(2) + block.local_jacobian * step.tail(1);
    EXPECT_LT((shown - (block.residuals - before)).norm(), 1e-12);
  }
}

// A straight function's derivatives stay what they are, and a step of nothing says nothing.
TEST(UpdatedDerivatives, StayWhereTheyAreRight) {
  const Eigen::MatrixXd linear{{1.0, 2.0}, {0.0, -1.0}, {4.0, 1.0}};
  const StepTaken step{.parameters = Eigen::Vector2d(0.5, -2.0),
                       .parameter_scales = Eigen::Vector2d(1.0, 3.0),
                       .local = Eigen::VectorXd(0),
                       .local_scales = Eigen::VectorXd(0)};
  ResidualValues::Block block{
      .residuals = linear * step.parameters, .jacobian = linear, .local_jacobian = Eigen::MatrixXd(3, 0)};
  update_derivatives(step, Eigen::Vector3d::Zero(), block);
  EXPECT_LT((block.jacobian - linear).norm(), 1e-14);
  StepTaken none = step;
  none.parameters.setZero();
  update_derivatives(none, block.residuals, block);
  EXPECT_TRUE(block.jacobian.allFinite());
}

TEST(Fit, WithUpdatedDerivativesReachesTheSameOptimumWithFewerRuns) {
  const replay::DeclaredModel declared = slide(3.0, 1.0);
  const auto run = slide_run(300, {}, no_error);
  const Prepared prepared(declared, run);
  FitRequest request{.hypothesis = &prepared.hypothesis, .runs = prepared.runs, .start = prepared.hypothesis.start()};
  const auto fresh = fit(request);
  const long simulated_afresh = prepared.simulated_runs();
  request.updates_derivatives = true;
  const auto updated = fit(request);
  ASSERT_TRUE(fresh && updated);
  EXPECT_NEAR(updated->values[0], true_mass, 1e-4 * true_mass);
  EXPECT_NEAR(updated->values[1], true_damping, 1e-4 * true_damping);
  EXPECT_LT(prepared.simulated_runs(), simulated_afresh);
}

TEST(Fit, OfNoIterationsMovesNothing) {
  const replay::DeclaredModel declared = slide(3.0, 1.0);
  const auto run = slide_run(100, {}, no_error);
  const Prepared prepared(declared, run);
  const auto there = evaluate_with_jacobian({.hypothesis = &prepared.hypothesis,
                                             .runs = prepared.runs,
                                             .start = prepared.hypothesis.start(),
                                             .effort = {.iterations = 0}});
  ASSERT_TRUE(there.has_value());
  EXPECT_EQ(there->values, prepared.hypothesis.start());
  EXPECT_EQ(prepared.simulated_runs(), 3);
}

TEST(Fit, JacobianIsThatOfTheClosedForm) {
  const replay::DeclaredModel declared = slide(true_mass, true_damping);
  const auto run = slide_run(100, {}, no_error);
  const Prepared prepared(declared, run);
  const Fit there = fitted(prepared);  // stays at the truth
  // From rest the motion depends on u/m and d/m only; so m d/dm + d d/dd is minus the motion itself, x(u).
  for (Eigen::Index i = 0; i < there.jacobian.rows(); ++i) {
    const double along = true_mass * there.jacobian(i, 0) + true_damping * there.jacobian(i, 1);
    EXPECT_NEAR(along * noise_sigma, run.channels.front().values[static_cast<std::size_t>(i)], 2e-4);
  }
}

TEST(Fit, CountsEveryRunThatItSimulates) {
  const replay::DeclaredModel declared = slide(true_mass, true_damping);
  const auto run = slide_run(100, {}, no_error);
  const Prepared prepared(declared, run);
  const FitRequest request{
      .hypothesis = &prepared.hypothesis, .runs = prepared.runs, .start = prepared.hypothesis.start()};
  EXPECT_TRUE(evaluate_at(request));
  EXPECT_EQ(prepared.simulated_runs(), 1);
  EXPECT_TRUE(evaluate_with_jacobian(request));
  EXPECT_EQ(prepared.simulated_runs(), 3);  // and once for each of the two parameters
}

// A curve of the declared model is one that just can be built.
TEST(Fit, StaysWhereEveryStepLeadsToNoModel) {
  replay::DeclaredModel declared = slide(3.0, 1.0);
  declared.build = [whole = declared.build](std::span<const double> values) {
    for (const auto& [value, start] : {std::pair(values[0], 3.0), std::pair(values[1], 1.0)})
      if (value != start && std::abs(std::abs(value / start - 1.0) - 1e-4) > 1e-9)  // the step of a derivative
        throw std::domain_error("curve: tolerance not reached");
    return whole(values);
  };
  const auto run = slide_run(100, {}, no_error);
  const Fit found = fitted(Prepared(declared, run));
  EXPECT_EQ(found.values, Eigen::Vector2d(3.0, 1.0));
  EXPECT_GT(found.jacobian.col(0).norm(), 0.0);
}

TEST(Fit, StaysWithinPhysicalBounds) {
  const replay::DeclaredModel declared = slide(true_mass, true_damping);
  const auto run = pushed_run();
  const Prepared prepared(declared, run, {{.kind = standard_effects().find("quadratic_drag"), .values = {0.1}}});
  const Fit found = fitted(prepared);
  EXPECT_EQ(found.values[2], 0.0);
  EXPECT_TRUE(found.at_bound[2]);
  EXPECT_FALSE(found.at_bound[0]);
}

TEST(Fit, KeepsAHeldParameter) {
  const replay::DeclaredModel declared = slide(true_mass, 2.5);
  const auto run = slide_run(200, {}, no_error);
  const Prepared prepared(declared, run);
  const auto found = fit({.hypothesis = &prepared.hypothesis,
                          .runs = prepared.runs,
                          .start = prepared.hypothesis.start(),
                          .held_parameter = 1});
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->values[1], 2.5);
  EXPECT_GT(std::abs(found->values[0] - true_mass), 0.01);  // the mass compensates in part
}

TEST(Fit, IsNotHeldUpByAWallThatOnlyAPriorPullsTowards) {
  // Away from the wall nothing but its prior has a slope: steps that follow it run into the wall.
  const replay::DeclaredModel declared = slide_with_wall(1.5 * true_mass, 0.5 * true_damping, 0.1);
  Normal normal(7);
  const auto run = slide_run(300, {}, [&] { return noise_sigma * normal(); });
  const Prepared prepared(declared, run);
  Eigen::VectorXd start = prepared.hypothesis.start();
  start[2] = -0.3;
  const auto found = fit({.hypothesis = &prepared.hypothesis, .runs = prepared.runs, .start = start});
  ASSERT_TRUE(found.has_value());
  EXPECT_NEAR(found->values[0], true_mass, 0.01 * true_mass);
  EXPECT_NEAR(found->values[1], true_damping, 0.01 * true_damping);
  // At 0, where the slide starts, by no more than the noise lets be seen.
  EXPECT_NEAR(found->values[2], 0.0, 0.005);
  EXPECT_LT(found->chi_square, 360.0);  // 300 samples of noise; 24 is its standard deviation
}

TEST(Fit, IsNotHeldBackByAWallThatIsNowhere) {
  replay::DeclaredModel declared = slide_with_wall(1.5 * true_mass, 0.5 * true_damping, 0.1);
  declared.calibration.back().other_start = -1.0;
  Normal normal(7);
  const auto run = slide_run(300, {}, [&] { return noise_sigma * normal(); });
  const Prepared prepared(declared, run);
  Eigen::VectorXd start = prepared.hypothesis.start();
  start[2] = -1.0;  // 22 tolerances away
  const auto found = fit({.hypothesis = &prepared.hypothesis, .runs = prepared.runs, .start = start});
  ASSERT_TRUE(found.has_value());
  EXPECT_NEAR(found->values[0], true_mass, 0.01 * true_mass);
  EXPECT_EQ(found->values[2], -1.0);
  EXPECT_TRUE(found->normal_matrix.col(2).isZero(0.0));
  EXPECT_DOUBLE_EQ(found->prior_chi_square, 9.0);  // three tolerances, and no more
}

TEST(Hypothesis, PullsNoHarderThanThePriorOfANumberThatMayBeNowhere) {
  replay::DeclaredModel declared = slide_with_wall(true_mass, true_damping, 0.1);  // within 0.05
  const auto squares = [&](double wall) {
    const Hypothesis hypothesis(declared, {});
    Eigen::VectorXd values = hypothesis.start();
    values[2] = wall;
    const Eigen::VectorXd residuals = hypothesis.prior_residuals(values);
    values[2] += 1e-7;
    const double slope = (hypothesis.prior_residuals(values) - residuals)[0] / 1e-7;
    EXPECT_NEAR(hypothesis.prior_jacobian(values)(0, 2), slope, 1e-6) << wall;
    return residuals.squaredNorm();
  };
  EXPECT_NEAR(squares(-0.1), 16.0, 1e-9);
  declared.calibration.back().other_start = -1.0;
  EXPECT_NEAR(squares(0.0), 4.0, 1e-9);
  EXPECT_NEAR(squares(-0.1), 9.0, 1e-9);
  EXPECT_NEAR(squares(-0.9), 9.0, 1e-9);
  EXPECT_NEAR(squares(0.4), 9.0, 1e-9);
}

TEST(Fit, FindsTheInitialStateOfEveryWindow) {
  const replay::DeclaredModel declared = slide(2.3, 2.7);
  const Place start{.position = 0.3, .speed = -0.8};
  Normal normal(5);
  data::Run run = slide_run(400, start, [&] { return noise_sigma * normal(); });
  run.start = data::Start::free;
  run.window = 1.0;
  const Prepared prepared(declared, run);
  ASSERT_EQ(prepared.runs.front().windows.size(), 4u);
  const Fit found = fitted(prepared);
  // Each window has 100 samples; the position at its start is known to about 2 noise / sqrt(100), the speed to about
  // four times that per second. The tolerances are five standard deviations.
  Place place = start;
  for (std::size_t window = 0; window < 4; ++window) {
    const std::vector<double>& state = found.runs.front().local_numbers[window];
    ASSERT_EQ(state.size(), 2U);
    EXPECT_NEAR(state[0], place.position, noise_sigma) << window;
    EXPECT_NEAR(state[1], place.speed, 10.0 * noise_sigma) << window;
    for (std::size_t i = 100 * window; i < 100 * (window + 1); ++i) place = slid(place, force_at(i), interval);
  }
  EXPECT_NEAR(found.values[0], true_mass, 0.03);
  EXPECT_NEAR(found.values[1], true_damping, 0.03);
}

// Only its first piece begins at rest. While all did, each was as far off as the slide had come.
TEST(Fit, FindsTheInitialStatesOfLaterWindowsOfARunAtRest) {
  Normal normal(5);
  data::Run run = slide_run(400, {}, [&] { return noise_sigma * normal(); });
  run.window = 1.0;
  const Prepared prepared(slide(2.3, 2.7), run);
  const Fit found = fitted(prepared);
  EXPECT_TRUE(found.runs.front().local_numbers[0].empty());
  EXPECT_EQ(found.runs.front().local_numbers[1].size(), 2U);
  EXPECT_NEAR(found.values[0], true_mass, 0.03);
  EXPECT_NEAR(found.values[1], true_damping, 0.03);
}

}  // namespace
}  // namespace coilwright::measurement::fit
