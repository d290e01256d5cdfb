#include "measurement/final_errors.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include "coilwright/measurement/replayed_runs.hpp"
#include "measurement/random_numbers.hpp"
#include "measurement/slider_model.hpp"

namespace coilwright::measurement {
namespace {

identification::FittedHypothesis fitted_to(const replay::DeclaredModel& declared, const data::Run& run) {
  fit::Hypothesis hypothesis(declared, {});
  const std::vector runs{replay::prepare_run(run, declared, hypothesis.model_at(hypothesis.start()))};
  auto found = fit::fit({.hypothesis = &hypothesis, .runs = runs, .start = hypothesis.start()});
  EXPECT_TRUE(found);
  return identification::score(runs, std::move(hypothesis), std::move(*found));
}

ThreeModels same_models(const identification::FittedHypothesis& model) {
  return {.declared = model, .before = model, .after = model, .overdispersion = 1.0};
}

// Fitted to 0.6 s of a slide with noise, and compared with 4 s without: the errors are due to the errors of the fitted
// numbers alone, and over many draws of noise their size is the uncertainty that is stated for a single draw.
TEST(FinalErrors, StateTheUncertaintyDueToTheFittedNumbers) {
  const replay::DeclaredModel declared = slide(2.2, 2.7);
  const std::vector<data::Run> judged{slide_run(400, {}, no_error)};
  constexpr int draws = 60;
  double observed = 0.0;
  double stated = 0.0;
  for (int seed = 1; seed <= draws; ++seed) {
    Normal normal(static_cast<std::uint64_t>(seed));
    const identification::FittedHypothesis model =
        fitted_to(declared, slide_run(60, {}, [&] { return noise_sigma * normal(); }));
    const FinalErrors errors(data::SealedRuns(judged), declared, same_models(model), {});
    ASSERT_EQ(errors.errors().size(), 1U);
    observed += std::pow(errors.errors().front().after.rmse, 2);
    stated += std::pow(errors.errors().front().uncertainty_rmse, 2);
  }
  EXPECT_GT(std::sqrt(observed / draws), 2.0 * noise_sigma);  // beyond the noise: an extrapolation
  // Two numbers: the mean of 60 squares is known to about 20 %, its root to 10 %.
  EXPECT_NEAR(std::sqrt(stated / observed), 1.0, 0.25);
}

using Wrong = std::vector<std::pair<std::size_t, double>>;  // samples, and by how many times the noise

// A slide beside a hum of four times the noise, some of its samples wrong.
struct HummingRun {
  data::Run run;
  data::Run still{.name = "still.csv",
                  .kind = data::RunKind::still,
                  .channels = {{.name = "theta1_rad", .kind = data::ChannelKind::joint_angle}}};
};

HummingRun humming_run(std::size_t samples, const Wrong& wrong) {
  Normal normal(5);
  const auto hum = [](double time) { return 4.0 * noise_sigma * std::cos(2.0 * std::numbers::pi * 20.0 * time); };
  HummingRun out;
  for (int i = 0; i < 2000; ++i) {
    out.still.times.push_back(interval * i);
    out.still.channels.front().values.push_back(noise_sigma * normal() + hum(interval * i));
  }
  out.run = slide_run(samples, {}, [&] { return noise_sigma * normal(); });
  out.run.sigma.reset();
  std::vector<double>& values = out.run.channels.front().values;
  for (std::size_t i = 0; i < values.size(); ++i) values[i] += hum(out.run.times[i]);
  for (const auto& [sample, size] : wrong) values[sample] += size * noise_sigma;
  return out;
}

std::vector<double> times_of(const data::Run& run, const Wrong& wrong) {
  std::vector<double> out;
  for (const auto& [sample, size] : wrong) out.push_back(run.times[sample]);
  return out;
}

// Outliers pull at the hum that is fitted to a run, and hide behind what it then leaves: many of one size each other,
// two large ones those that are smaller. Without them the error is the noise, and each of them is listed.
TEST(FinalErrors, LeaveOutliersOutOfARunWithHum) {
  const replay::DeclaredModel declared = slide(2.2, 2.7);
  const identification::FittedHypothesis model = fitted_to(declared, slide_run(400, {}, no_error));
  for (const Wrong& wrong : {Wrong{{10, -40.0},
                                   {21, 52.0},
                                   {33, 64.0},
                                   {34, -76.0},
                                   {55, 88.0},
                                   {70, 100.0},
                                   {83, -112.0},
                                   {97, 124.0},
                                   {110, 136.0}},
                             Wrong{{20, 600.0}, {45, 15.0}, {60, 560.0}, {75, -16.0}, {101, 14.0}}}) {
    const HummingRun made = humming_run(120, wrong);
    const FinalErrors errors(data::SealedRuns({made.run}), declared, same_models(model), std::vector{made.still});
    ASSERT_EQ(errors.outliers().size(), 1U);
    EXPECT_TRUE(errors.outliers().front().validate);
    EXPECT_EQ(errors.outliers().front().times, times_of(made.run, wrong));
    ASSERT_EQ(errors.errors().size(), 1U);
    EXPECT_EQ(errors.errors().front().samples, 120 - wrong.size());
    EXPECT_NEAR(errors.errors().front().after.rmse / noise_sigma, 1.0, 0.15);
    ASSERT_EQ(errors.replays().size(), 1U);
    EXPECT_EQ(std::ranges::count(errors.replays().front().left_out, 1), static_cast<std::ptrdiff_t>(wrong.size()));
  }
}

// Of fit runs what the fits had set aside is left out, no more and no less.
// Five of 41 pictures are wrong, and pull the hum with them, by which the others are then off from one to the next.
TEST(FinalErrors, LeaveManyOutliersOutOfAShortRun) {
  const replay::DeclaredModel declared = slide(2.2, 2.7);
  const identification::FittedHypothesis model = fitted_to(declared, slide_run(400, {}, no_error));
  const Wrong wrong{{5, 40.0}, {10, 40.0}, {20, 12.0}, {25, 40.0}, {30, 12.0}};
  const HummingRun made = humming_run(41, wrong);
  const FinalErrors errors(data::SealedRuns({made.run}), declared, same_models(model), std::vector{made.still});
  ASSERT_EQ(errors.outliers().size(), 1U);
  EXPECT_EQ(errors.outliers().front().times, times_of(made.run, wrong));
  EXPECT_LT(errors.errors().front().after.rmse / noise_sigma, 1.2);
}

TEST(FinalErrors, OfFitRunsLeaveOutWhatTheFitsDid) {
  const replay::DeclaredModel declared = slide(true_mass, true_damping);
  const fit::Hypothesis hypothesis(declared, {});
  const data::Run run = slide_run(100, {}, no_error);
  replay::PreparedRun prepared = replay::prepare_run(run, declared, hypothesis.model_at(hypothesis.start()));
  prepared.set_aside = {std::vector<char>(100, 0)};
  prepared.set_aside.front()[40] = 1;
  const FinalErrors errors({prepared}, same_models(fitted_to(declared, run)));
  ASSERT_EQ(errors.outliers().size(), 1U);
  EXPECT_FALSE(errors.outliers().front().validate);
  EXPECT_EQ(errors.outliers().front().times, std::vector{run.times[40]});
  EXPECT_EQ(errors.errors().front().samples, 99U);
}

// A model is shown in the runs of a set as the errors of a diagnosis have it, with hum and outliers.
TEST(ReplayedRuns, ShowModelsAsTheErrorsOfADiagnosisDo) {
  const replay::DeclaredModel declared = slide(2.2, 2.7);
  identification::FittedHypothesis model = fitted_to(declared, slide_run(400, {}, no_error));
  model.fit.values = model.hypothesis.start();
  const HummingRun made = humming_run(120, {{20, 600.0}, {45, 150.0}, {60, 560.0}});
  const FinalErrors errors(data::SealedRuns({made.run}), declared, same_models(model), std::vector{made.still});
  const Replay& expected = errors.replays().front();
  const ReplayedRuns runs(
      {.fit = {slide_run(100, {}, no_error)}, .validate = data::SealedRuns({made.run}), .still = {made.still}},
      declared, {.model_error = 1.0, .outliers = errors.outliers()});
  ASSERT_EQ(runs.size(), 2U);
  EXPECT_FALSE(runs.channels(0).front().validate);
  const Replay& measured = runs.channels(1).front();
  EXPECT_TRUE(measured.validate);
  EXPECT_EQ(measured.at, expected.at);
  EXPECT_EQ(measured.measured, expected.measured);
  EXPECT_EQ(measured.left_out, expected.left_out);
  EXPECT_EQ(runs.shown_of(1, declared)->front(), expected.before);
  EXPECT_NE(runs.shown_of(1, slide(true_mass, true_damping))->front(), expected.before);
}

}  // namespace
}  // namespace coilwright::measurement
