#include "measurement/identification/model_error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <span>
#include <vector>

#include "coilwright/measurement/diagnosis.hpp"
#include "measurement/identification/staged_fit.hpp"
#include "measurement/random_numbers.hpp"
#include "measurement/slider_model.hpp"

namespace coilwright::measurement::identification {
namespace {

constexpr double mass_tolerance = 0.02;  // kg

// A slide whose damping is fitted and whose mass is weighed.
replay::DeclaredModel slide_with_tolerance() {
  replay::DeclaredModel declared = slide(true_mass, true_damping);
  declared.calibration.front().tolerance = replay::Tolerance{.deviation = mass_tolerance};
  declared.calibration.front().scale = mass_tolerance;
  declared.calibration.front().calibrated = false;
  return declared;
}

// In windows whose starts are fitted, with a wave in the scale of the sensor that no model here has: 40 times the
// noise.
data::Run run_in_windows() {
  Normal normal(4);
  data::Run run = slide_run(400, {}, [&, sample = 0]() mutable {
    const double wave = std::sin(0.07 * static_cast<double>(sample++));
    return noise_sigma * (40.0 * wave + normal());
  });
  run.start = data::Start::free;
  run.window = 2.0;
  return run;
}

std::vector<replay::PreparedRun> prepared(const data::Run& run, const replay::DeclaredModel& declared) {
  const fit::Hypothesis plain(declared, {});
  return {replay::prepare_run(run, declared, plain.model_at(plain.start()))};
}

FittedHypothesis fitted(std::span<const replay::PreparedRun> runs, const replay::DeclaredModel& declared) {
  PlannedFit plan{.hypothesis = fit::Hypothesis(declared, {})};
  plan.start = plan.hypothesis.start();
  auto found = fit_exactly(runs, plan);
  EXPECT_TRUE(found.has_value());
  return std::move(*found);
}

double tolerances_moved(const FittedHypothesis& found) {
  return std::abs(found.fit.values[0] - true_mass) / mass_tolerance;
}

// Priors that hold w times as much are those of a measurement with w times the noise: of the declared mass and of the
// start of every window.
TEST(ModelError, WeighsPriorsAsThatMuchMoreNoiseDoes) {
  constexpr double times = 40.0;
  const replay::DeclaredModel declared = slide_with_tolerance();
  const data::Run run = run_in_windows();
  data::Run noisier = run;
  noisier.sigma = times * *run.sigma;
  std::vector<replay::PreparedRun> weighed = prepared(run, declared);
  set_model_error(weighed, times);
  const FittedHypothesis one = fitted(weighed, declared);
  const FittedHypothesis other = fitted(prepared(noisier, declared), declared);
  EXPECT_NEAR(one.fit.values[0], other.fit.values[0], 1e-3 * mass_tolerance);
  EXPECT_NEAR(one.fit.values[1], other.fit.values[1], 1e-4 * true_damping);
  EXPECT_NEAR(one.fit.prior_chi_square, other.fit.prior_chi_square, 1e-2 * other.fit.prior_chi_square);
  EXPECT_NEAR(one.fit.chi_square, times * times * other.fit.chi_square, 1e-3 * one.fit.chi_square);
  EXPECT_NEAR(one.fit.objective(), times * times * other.fit.objective(), 1e-3 * one.fit.objective());
}

TEST(ModelError, IsNoneNearTheNoise) {
  Normal normal(3);
  const replay::DeclaredModel declared = slide_with_tolerance();
  const data::Run run = slide_run(300, {}, [&] { return noise_sigma * normal(); });
  const std::vector<replay::PreparedRun> runs = prepared(run, declared);
  EXPECT_EQ(model_error_of(runs, fitted(runs, declared)), 1.0);
}

TEST(ModelError, KeepsDeclaredNumbersNearTheirTolerances) {
  const replay::DeclaredModel declared = slide_with_tolerance();
  const data::Run run = run_in_windows();
  std::vector<replay::PreparedRun> runs = prepared(run, declared);
  const FittedHypothesis against_noise = fitted(runs, declared);
  ASSERT_TRUE(is_far_from_noise(against_noise)) << against_noise.whiteness.level;
  EXPECT_GT(tolerances_moved(against_noise), 6.0) << against_noise.whiteness.level;
  const double model_error = model_error_of(runs, against_noise);
  EXPECT_GT(model_error, against_noise.whiteness.level);  // what is left over is no white noise
  set_model_error(runs, model_error);
  EXPECT_LT(tolerances_moved(fitted(runs, declared)), 3.0);
}

// The whole diagnosis, with no effect that it could name.
TEST(ModelError, IsThatOfTheAnswer) {
  const replay::DeclaredModel declared = slide_with_tolerance();
  data::Dataset data;
  data.fit = {run_in_windows()};
  const Diagnosis found = diagnose(data, declared, {.effects = actuator::EffectCatalogue()});
  EXPECT_EQ(found.verdict, Verdict::unexplained);
  ASSERT_EQ(found.nominal.size(), 1U);
  const MovedNumber& mass = found.nominal.front();
  EXPECT_LT(std::abs(mass.estimate.value - true_mass), 3.0 * mass_tolerance);
  EXPECT_TRUE(mass.estimate.lower <= true_mass && true_mass <= mass.estimate.upper)
      << mass.estimate.lower << " to " << mass.estimate.upper;
}

}  // namespace
}  // namespace coilwright::measurement::identification
