#include "measurement/records/exchanged_runs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "measurement/random_numbers.hpp"
#include "measurement/slider_model.hpp"

namespace coilwright::measurement::records {
namespace {

constexpr double spring = 100.0;  // Nm/rad

replay::DeclaredModel declared_slide() {
  replay::DeclaredModel declared = slide(true_mass, 0.1);
  declared.build = [](std::span<const double> values) {
    actuator::ModelSpec spec = slide(true_mass, 0.1).build(values);
    spec.hinges.front().stiffness = spring;
    spec.hinges.front().damping = 2.0 * spring;  // it creeps within seconds: its pose is nearly its torque's
    return spec;
  };
  return declared;
}

// The torque is a sine that would hold `held` at its top, rad; the angle creeps after it as of a model `gain` times as
// soft, with noise.
data::Run swung(const std::string& name, double held, double cycles, double gain, unsigned seed) {
  data::Run run = slide_run(200, {}, no_error);
  run.name = name;
  run.start = data::Start::at_rest;
  Normal normal(seed);
  double angle = 0.0;
  for (std::size_t i = 0; i < run.inputs.size(); ++i) {
    const double torque = held * spring * std::sin(2.0 * std::numbers::pi * cycles * static_cast<double>(i) / 200.0);
    run.inputs[i] = {torque};
    run.channels.front().values[i] = gain * angle + 1e-3 * normal();
    angle += interval * (torque - spring * angle) / (2.0 * spring);
  }
  return run;
}

std::vector<data::Run> three(double gain) {
  return {swung("slow.csv", 0.4, 1.0, gain, 1), swung("quick.csv", 0.4, 3.0, gain, 2),
          swung("weak.csv", 0.36, 1.0, gain, 3)};
}

std::vector<data::Run> with_exchanged(std::vector<data::Run> runs, std::size_t a, std::size_t b) {
  std::swap(runs[a].channels, runs[b].channels);
  return runs;
}

TEST(ExchangedRuns, AreNamedInPairs) {
  const auto found = exchanged_runs(with_exchanged(three(1.0), 0, 1), declared_slide());
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found.front().run, "slow.csv");
  EXPECT_EQ(found.front().text,
            "its readings are what the declared model shows of the input of quick.csv, and those of quick.csv what it "
            "shows of this one's: were the two exchanged? If so, give each its own input again");
}

TEST(ExchangedRuns, AreFoundWhereTheModelIsATenthOffAndWhereTheyDifferByAsMuch) {
  EXPECT_EQ(exchanged_runs(with_exchanged(three(1.1), 0, 1), declared_slide()).size(), 1U);
  EXPECT_EQ(exchanged_runs(with_exchanged(three(1.0), 0, 2), declared_slide()).size(), 1U);
}

// A model that is off in its gain puts one run nearer to another's motion, and never both.
TEST(ExchangedRuns, AreNoneWhereEachHasItsOwnInput) {
  for (const double gain : {0.5, 0.9, 1.0, 1.1, 2.0})
    EXPECT_TRUE(exchanged_runs(three(gain), declared_slide()).empty());
  EXPECT_TRUE(exchanged_runs({}, declared_slide()).empty());
}

}  // namespace
}  // namespace coilwright::measurement::records
