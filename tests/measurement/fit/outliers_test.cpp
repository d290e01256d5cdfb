#include "measurement/fit/outliers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "measurement/fit/fit.hpp"
#include "measurement/random_numbers.hpp"
#include "measurement/slider_model.hpp"

namespace coilwright::measurement::fit {
namespace {

constexpr double count = 1e-3;  // of the encoder, m
constexpr std::size_t misread = 250;

// A slide at rest, half a count from the next one, with noise of 0.4 counts: one reading in ten is the next count, and
// most are equal to the one before.
data::Run rounded_record() {
  Normal normal(11);
  data::Run run = slide_run(500, {}, no_error);
  run.sigma.reset();
  for (std::size_t i = 0; i < run.times.size(); ++i) {
    run.inputs[i] = {0.0};
    run.channels.front().values[i] = count * std::round(0.4 * normal());
  }
  run.channels.front().values[misread] = 10.0 * count;
  return run;
}

TEST(OutliersOfARoundedRecord, AreNoStepsToTheNextValue) {
  const data::Run run = rounded_record();
  const replay::DeclaredModel declared = slide(true_mass, true_damping);
  const Hypothesis hypothesis(declared, {});
  std::vector<replay::PreparedRun> runs{replay::prepare_run(run, declared, hypothesis.model_at(hypothesis.start()))};
  const auto there = evaluate_at({.hypothesis = &hypothesis, .runs = runs, .start = hypothesis.start()});
  ASSERT_TRUE(there.has_value());
  EXPECT_TRUE(set_outliers_aside(runs, *there));
  for (std::size_t i = 0; i < run.times.size(); ++i)
    EXPECT_EQ(runs.front().is_set_aside(0, i), i == misread) << i << ": " << run.channels.front().values[i];
}

TEST(OutliersOfARoundedRecord, LeaveNoLessNoiseThanRoundingMakes) {
  const data::Run run = rounded_record();
  const replay::DeclaredModel declared = slide(true_mass, true_damping);
  const Hypothesis hypothesis(declared, {});
  std::vector<replay::PreparedRun> runs{replay::prepare_run(run, declared, hypothesis.model_at(hypothesis.start()))};
  // Predictions that move smoothly between the counts: what they leave has no counts any more.
  auto there = evaluate_at({.hypothesis = &hypothesis, .runs = runs, .start = hypothesis.start()});
  ASSERT_TRUE(there.has_value());
  Eigen::VectorXd& predictions = there->runs.front().predictions;
  for (Eigen::Index i = 0; i < predictions.size(); ++i) predictions[i] = 1e-6 * std::sin(0.01 * static_cast<double>(i));
  (void)set_outliers_aside(runs, *there);
  EXPECT_GE(runs.front().noise.front().sigma, count / std::sqrt(12.0) * (1.0 - 1e-9));
}

// The level is taken anew; what is known of the spectrum stays known, and what is not, unknown.
TEST(OutliersOfARoundedRecord, TellNothingOfTheColourOfNoise) {
  const data::Run run = rounded_record();
  const replay::DeclaredModel declared = slide(true_mass, true_damping);
  const Hypothesis hypothesis(declared, {});
  for (const bool unknown : {true, false}) {
    std::vector<replay::PreparedRun> runs{replay::prepare_run(run, declared, hypothesis.model_at(hypothesis.start()))};
    runs.front().noise.front().colour_unknown = unknown;
    const auto there = evaluate_at({.hypothesis = &hypothesis, .runs = runs, .start = hypothesis.start()});
    ASSERT_TRUE(there.has_value());
    (void)set_outliers_aside(runs, *there);
    EXPECT_EQ(runs.front().noise.front().colour_unknown, unknown);
  }
}

// Forty pictures of a slide whose clock may be off. Three of them are misread by so much that a fit moves the clock.
struct MisreadRecord {
  MisreadRecord() {
    Normal normal(3);
    run = slide_run(40, {}, [&] { return noise_sigma * normal(); });
    run.clock.offset_sigma = 0.05;
    for (const std::size_t i : misread_ones) run.channels.front().values[i] += 30.0 * noise_sigma;
    runs.push_back(replay::prepare_run(run, declared, hypothesis.model_at(hypothesis.start())));
  }
  [[nodiscard]] Fit fitted(std::span<const replay::PreparedRun> to) const {
    auto out = fit({.hypothesis = &hypothesis, .runs = to, .start = hypothesis.start()});
    EXPECT_TRUE(out.has_value());
    return std::move(*out);
  }
  [[nodiscard]] std::vector<std::size_t> set_aside() const {
    std::vector<std::size_t> out;
    for (std::size_t i = 0; i < run.times.size(); ++i)
      if (runs.front().is_set_aside(0, i)) out.push_back(i);
    return out;
  }

  const std::vector<std::size_t> misread_ones{11, 20, 30};
  replay::DeclaredModel declared = slide(true_mass, true_damping);
  Hypothesis hypothesis{declared, {}};
  data::Run run;
  std::vector<replay::PreparedRun> runs{};
};

TEST(SuspectedOutliers, AreThoseFarFromWhatMostSamplesLeave) {
  const MisreadRecord record;
  const Fit fitted = record.fitted(record.runs);
  const auto without = with_suspects_aside(record.runs, fitted);
  ASSERT_TRUE(without.has_value());
  for (std::size_t i = 0; i < record.run.times.size(); ++i)
    EXPECT_EQ(without->front().is_set_aside(0, i), std::ranges::count(record.misread_ones, i) > 0) << i;
  EXPECT_TRUE(record.set_aside().empty());  // only suspected
  // The clock without them.
  const double clock = record.fitted(*without).runs.front().local_numbers.front().front();
  EXPECT_NEAR(clock, 0.0, 0.01);
  EXPECT_GT(std::abs(fitted.runs.front().local_numbers.front().front()), std::abs(clock));
}

TEST(SuspectedOutliers, AreNoneWhereManySamplesAreFar) {
  MisreadRecord record;
  for (std::size_t i = 12; i < 18; i += 2) record.run.channels.front().values[i] += 30.0 * noise_sigma;
  EXPECT_FALSE(with_suspects_aside(record.runs, record.fitted(record.runs)).has_value());
}

TEST(OutliersThatAreTakenBack, AreThoseThatTheFinalModelReaches) {
  MisreadRecord record;
  std::vector<char> aside(record.run.times.size(), 0);
  for (const std::size_t i : record.misread_ones) aside[i] = 1;
  aside[5] = 1;  // good
  record.runs.front().whiteners.resize(1);
  record.runs.front().set_aside = {aside};
  const Fit fitted = record.fitted(record.runs);
  EXPECT_TRUE(take_back(record.runs, fitted));
  EXPECT_EQ(record.set_aside(), record.misread_ones);
  EXPECT_FALSE(take_back(record.runs, fitted));
}

}  // namespace
}  // namespace coilwright::measurement::fit
