#include "measurement/replay/input_whitener.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>

#include "measurement/slider_model.hpp"

namespace coilwright::measurement::replay {
namespace {

constexpr double input_sigma = 0.2;  // N

struct Weighed {
  data::Run run;
  actuator::Model model;
  PreparedRun prepared;
};

actuator::Model true_slide() {
  const DeclaredModel declared = slide(true_mass, true_damping);
  return actuator::Model(declared.build(std::vector{true_mass, true_damping}));
}

// A slide whose force was read with errors, and its whiteners about where it goes.
Weighed weighed_slide(std::size_t samples, double correlation) {
  Weighed out{.run = slide_run(samples, {}, no_error), .model = true_slide(), .prepared = {}};
  out.run.start = data::Start::free;
  out.run.input_uncertainty = {.sigma = {input_sigma}, .correlation = correlation};
  return out;
}

void weigh(Weighed& slide) {
  slide.prepared = prepare_run(slide.run, measurement::slide(true_mass, true_damping), slide.model);
  weigh_input_errors(slide.prepared, slide.model, {});
}

// What one newton in the time from one sample to the next does to all that come after, in closed form.
Eigen::MatrixXd responses(std::size_t samples) {
  const auto n = static_cast<Eigen::Index>(samples);
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index k = 0; k < n; ++k) {
    Place place = slid({}, 1.0, interval);
    for (Eigen::Index i = k + 1; i < n; ++i) {
      out(i, k) = place.position;
      place = slid(place, 0.0, interval);
    }
  }
  return out;
}

// The innovations of a record are the inverse Cholesky factor of its covariance, which is known here as a whole.
TEST(InputWhitener, IsTheInverseCholeskyFactorOfTheCovariance) {
  constexpr std::size_t samples = 60;
  Weighed slide = weighed_slide(samples, 0.0);
  weigh(slide);
  const Window& window = slide.prepared.windows.front();
  ASSERT_NE(window.input_whitener, nullptr);
  const Eigen::MatrixXd by_force = responses(samples);
  Eigen::MatrixXd covariance = input_sigma * input_sigma * by_force * by_force.transpose();
  const Eigen::VectorXd deviations = covariance.diagonal().cwiseSqrt();
  covariance.diagonal().array() += noise_sigma * noise_sigma;
  Normal normal(3);
  Eigen::VectorXd differences(static_cast<Eigen::Index>(samples));
  for (double& each : differences) each = 0.01 * normal();
  const Eigen::MatrixXd factor = covariance.llt().matrixL();
  const Eigen::VectorXd expected = factor.triangularView<Eigen::Lower>().solve(differences);
  const Eigen::VectorXd found = over_noise(slide.prepared, window.range, differences);
  EXPECT_LT((found - expected).lpNorm<Eigen::Infinity>(), 1e-5 * expected.lpNorm<Eigen::Infinity>());
  EXPECT_LT((window.input_whitener->deviations() - deviations).lpNorm<Eigen::Infinity>(), 1e-5 * deviations.maxCoeff());
}

// A sample that is set aside tells nothing: as if the record did not have it.
TEST(InputWhitener, PassesOverSamplesThatAreSetAside) {
  constexpr std::size_t samples = 40;
  constexpr Eigen::Index aside = 17;
  Weighed slide = weighed_slide(samples, 0.0);
  slide.prepared = prepare_run(slide.run, measurement::slide(true_mass, true_damping), slide.model);
  slide.prepared.set_aside = {std::vector<char>(samples, 0)};
  slide.prepared.set_aside[0][aside] = 1;
  weigh_input_errors(slide.prepared, slide.model, {});
  const Eigen::MatrixXd by_force = responses(samples);
  Eigen::MatrixXd covariance = input_sigma * input_sigma * by_force * by_force.transpose();
  covariance.diagonal().array() += noise_sigma * noise_sigma;
  covariance(aside, aside) += 1e6;  // m^2: as good as no reading
  Normal normal(4);
  Eigen::VectorXd differences(static_cast<Eigen::Index>(samples));
  for (double& each : differences) each = 0.01 * normal();
  const Eigen::MatrixXd factor = covariance.llt().matrixL();
  Eigen::VectorXd expected = factor.triangularView<Eigen::Lower>().solve(differences);
  expected[aside] = 0.0;
  differences[aside] = 1e3;  // whatever it is
  const Eigen::VectorXd found = over_noise(slide.prepared, slide.prepared.windows.front().range, differences);
  EXPECT_LT((found - expected).lpNorm<Eigen::Infinity>(), 1e-5 * expected.lpNorm<Eigen::Infinity>());
}

// Errors that last: their variance adds up as that of an Ornstein-Uhlenbeck process, summed here in steps of 0.5 ms.
TEST(InputWhitener, CountsErrorsThatLastForAsLongAsTheyDo) {
  constexpr std::size_t samples = 60;
  constexpr double correlation = 0.08;  // s
  Weighed slide = weighed_slide(samples, correlation);
  weigh(slide);
  constexpr Eigen::Index parts = 20;
  const Eigen::Index steps = (static_cast<Eigen::Index>(samples) - 1) * parts;
  const double step = interval / static_cast<double>(parts);
  Eigen::MatrixXd errors(steps, steps);
  for (Eigen::Index i = 0; i < steps; ++i)
    for (Eigen::Index k = 0; k < steps; ++k)
      errors(i, k) = input_sigma * input_sigma * std::exp(-std::abs(static_cast<double>(i - k)) * step / correlation);
  for (const Eigen::Index sample : {Eigen::Index{5}, Eigen::Index{20}, Eigen::Index{59}}) {
    Eigen::VectorXd by_force = Eigen::VectorXd::Zero(steps);
    for (Eigen::Index k = 0; k < sample * parts; ++k)
      by_force[k] = slid(slid({}, 1.0, step), 0.0, static_cast<double>(sample * parts - k - 1) * step).position;
    const double expected = std::sqrt(by_force.dot(errors * by_force));
    // Held over 4 ms, they are correlated as those of a continuous process to 2 %.
    EXPECT_NEAR(slide.prepared.windows.front().input_whitener->deviations()[sample], expected, 0.02 * expected)
        << sample;
  }
}

// A pendulum at rest hangs where the force that acted holds it, not where the recorded one would.
TEST(InputWhitener, KnowsThatARestIsThatOfTheRecordedInput) {
  const mechanics::Link link{.length = 1.0, .com_along = 1.0, .com_offset = 0.0, .mass = 1.0, .inertia = 0.0};
  const actuator::Model pendulum(actuator::ModelSpec{.chain = mechanics::PlanarChain(std::span(&link, 1), 9.81),
                                                     .hinges = {actuator::Hinge{.damping = 0.1}},
                                                     .magnetics = {},
                                                     .coils = 0,
                                                     .tip = {}});
  data::Run run = slide_run(40, {}, no_error);
  for (std::vector<double>& row : run.inputs) row = {0.0};
  run.input_uncertainty = {.sigma = {input_sigma}};
  PreparedRun prepared = prepare_run(run, DeclaredModel{}, pendulum);
  weigh_input_errors(prepared, pendulum, {});
  EXPECT_NEAR(prepared.windows.front().input_whitener->deviations()[0], input_sigma / 9.81, 1e-6);
}

TEST(InputWhitener, IsNotThereWhereTheInputIsExact) {
  Weighed slide = weighed_slide(20, 0.0);
  slide.run.input_uncertainty = {};
  weigh(slide);
  EXPECT_EQ(slide.prepared.windows.front().input_whitener, nullptr);
  EXPECT_FALSE(weighs_input_errors(std::span(&slide.prepared, 1)));
}

}  // namespace
}  // namespace coilwright::measurement::replay
