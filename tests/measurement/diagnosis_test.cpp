#include "coilwright/measurement/diagnosis.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "coilwright/formats/data/diagnosis_json.hpp"
#include "measurement/random_numbers.hpp"
#include "measurement/slider_model.hpp"

namespace coilwright::measurement {
namespace {

// Only the friend named in dataset.hpp can read sealed runs: there is no member, conversion or iteration.
template <typename T>
concept ShowsItsMember = requires(T& sealed) {
  sealed.runs_;
};
template <typename T>
concept ShowsRuns = requires(T& sealed) {
  sealed.runs();
};
template <typename T>
concept IsARange = requires(T& sealed) {
  sealed.begin();
}
|| requires(T& sealed) {
  sealed[0];
}
|| requires(T& sealed) {
  *sealed;
};
static_assert(!ShowsItsMember<data::SealedRuns> && !ShowsItsMember<const data::SealedRuns>);
static_assert(!ShowsRuns<data::SealedRuns> && !IsARange<data::SealedRuns>);
static_assert(!std::convertible_to<data::SealedRuns, std::vector<data::Run>>);

// A run whose angle is read 10 standard deviations too high.
data::Run misread(const std::string& name, double amplitude, std::uint64_t seed) {
  Normal normal(seed);
  data::Run run = slide_run(150, {}, [&] { return 10.0 * noise_sigma + noise_sigma * normal(); });
  run.name = name;
  for (std::size_t i = 0; i < run.times.size(); ++i) run.channels.front().values[i] *= amplitude;
  return run;
}

data::Dataset set_with(std::vector<data::Run> validate) {
  data::Dataset data{.name = "slide", .validate = data::SealedRuns(std::move(validate))};
  data.fit = {misread("a.csv", 1.0, 1), misread("b.csv", 1.0, 2)};
  return data;
}

nlohmann::ordered_json report_of(const data::Dataset& data, int threads) {
  const Diagnosis diagnosis = diagnose(data, slide(2.2, 2.7), {.threads = threads});
  return nlohmann::ordered_json::parse(
      formats::to_json({.diagnosis = diagnosis, .dataset = data.name, .updated_actuator = "actuator.json"}).text());
}

// The report without the errors on validate runs and without the warnings about them.
std::string without_validate_errors(nlohmann::ordered_json report) {
  report["error"].erase("validate");
  auto& outliers = report["outliers"];
  for (std::size_t i = outliers.size(); i-- > 0;)
    if (outliers[i]["role"] == "validate") outliers.erase(i);
  for (const char* key : {"warnings", "unanswered_runs"}) {
    auto& warnings = report[key];
    for (std::size_t i = warnings.size(); i-- > 0;)
      if (warnings[i]["run"] == "v.csv" || warnings[i].dump().find("no fit has seen") != std::string::npos)
        warnings.erase(i);
  }
  return report.dump();
}

TEST(Diagnose, IsIndependentOfTheValidateRunsExceptForTheirErrors) {
  const nlohmann::ordered_json right = report_of(set_with({misread("v.csv", 1.0, 3)}), 2);
  ASSERT_EQ(right["verdict"], "explained");
  ASSERT_FALSE(right["effects"].empty());

  data::Run noisy = misread("v.csv", 1.0, 4);
  Normal normal(5);
  for (double& value : noisy.channels.front().values) value = normal();
  data::Run constant = misread("v.csv", 0.0, 6);
  data::Run pushed_hard = misread("v.csv", -40.0, 7);
  for (std::vector<double>& row : pushed_hard.inputs) row.front() *= 25.0;
  for (const data::Run& garbage : {noisy, constant, pushed_hard}) {
    const nlohmann::ordered_json wrong = report_of(set_with({garbage}), 2);
    EXPECT_NE(wrong["error"]["validate"], right["error"]["validate"]);
    EXPECT_EQ(without_validate_errors(wrong), without_validate_errors(right));
  }
}

TEST(Diagnose, NamesRunsThatDoNotAnswerTheirInput) {
  data::Run dead = misread("v.csv", 0.0, 6);
  std::ranges::fill(dead.channels.front().values, 0.0);
  const nlohmann::ordered_json held_out = report_of(set_with({dead}), 2);
  ASSERT_EQ(held_out["unanswered_runs"].size(), 1U);
  EXPECT_EQ(held_out["unanswered_runs"][0]["run"], "v.csv");
  EXPECT_EQ(std::ranges::count(held_out["warnings"], held_out["unanswered_runs"][0]), 1);
  EXPECT_TRUE(report_of(set_with({misread("v.csv", 1.0, 3)}), 2)["unanswered_runs"].empty());
}

TEST(Diagnose, GivesTheSameBytesOnAnyNumberOfThreads) {
  const data::Dataset data = set_with({misread("v.csv", 1.0, 3)});
  EXPECT_EQ(report_of(data, 1).dump(), report_of(data, 2).dump());
}

TEST(Diagnose, GivesTheSameBytesWithFreeInitialStates) {
  data::Dataset data;
  data.name = "slide";
  data.fit.push_back(pushed_run());
  data.fit.front().start = data::Start::free;
  data.fit.front().window = 0.2;
  EXPECT_EQ(report_of(data, 1).dump(), report_of(data, 2).dump());
}

TEST(Diagnose, FindsTheMisreadAngle) {
  const Diagnosis diagnosis = diagnose(set_with({misread("v.csv", 1.0, 3)}), slide(2.2, 2.7), {.threads = 2});
  ASSERT_EQ(diagnosis.effects.size(), 1u);
  EXPECT_EQ(diagnosis.effects.front().kind->id(), "angle_offset");
  const identification::Estimate& angle = diagnosis.effects.front().parameters.front();
  EXPECT_NEAR(angle.value, 10.0 * noise_sigma, 0.3 * noise_sigma);
  EXPECT_LE(angle.lower, 10.0 * noise_sigma);
  EXPECT_GE(angle.upper, 10.0 * noise_sigma);
}

TEST(Diagnose, NeverReportsANegativeDrag) {
  data::Dataset data;
  data.fit.push_back(pushed_run());
  const Diagnosis diagnosis = diagnose(data, slide(true_mass, true_damping), {.threads = 2});
  EXPECT_FALSE(diagnosis.before.is_white());
  for (const AddedEffect& effect : diagnosis.effects) EXPECT_NE(effect.kind->id(), "quadratic_drag");
}

}  // namespace
}  // namespace coilwright::measurement
