#include "measurement/replay/local_numbers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "measurement/fit/fit.hpp"
#include "measurement/replay/prediction.hpp"
#include "measurement/slider_model.hpp"

namespace coilwright::measurement::replay {
namespace {

constexpr std::size_t still_samples = 20;

// The slide rests for 0.2 s before it is pushed. The force has a clock of its own.
data::Run late_start(std::uint64_t seed) {
  data::Run run = slide_run(250, {}, no_error);
  Normal normal(seed);
  std::vector<double>& values = run.channels.front().values;
  values.insert(values.begin(), still_samples, 0.0);
  run.inputs.insert(run.inputs.begin(), still_samples, {0.0});
  run.times.clear();
  for (std::size_t i = 0; i < values.size(); ++i) {
    run.times.push_back(interval * static_cast<double>(i));
    values[i] += noise_sigma * normal();
  }
  run.input_times = run.times;
  return run;
}

struct Fitted {
  LocalNumbers numbers{};
  std::vector<double> values{};
  fit::Fit fit{};
};

Fitted fitted(const data::Run& run) {
  const DeclaredModel declared = slide(true_mass, true_damping);
  const fit::Hypothesis hypothesis(declared, {});
  const std::vector<PreparedRun> runs{prepare_run(run, declared, hypothesis.model_at(hypothesis.start()))};
  auto found = fit::fit({.hypothesis = &hypothesis, .runs = runs, .start = hypothesis.start()});
  EXPECT_TRUE(found.value.has_value());
  Fitted out{.numbers = LocalNumbers(runs.front(), runs.front().windows.front()), .fit = found.value.value()};
  out.values = out.fit.runs.front().local_numbers.front();
  return out;
}

TEST(LocalNumbers, OfOneClockAndAStartAtRestAreNone) {
  EXPECT_EQ(fitted(late_start(1)).numbers.size(), 0u);
}

TEST(LocalNumbers, FindTheShiftOfTheClocks) {
  for (const double shift : {-0.013, 0.008}) {
    data::Run run = late_start(2);
    for (double& time : run.times) time += shift;  // stamped so much too late
    run.clock.offset_sigma = 0.02;
    const Fitted found = fitted(run);
    ASSERT_EQ(found.numbers.size(), 1u);
    // The slide moves at about 0.5 m/s, so that 250 readings of a millimetre tell 0.13 ms.
    EXPECT_NEAR(found.numbers.clock_offset(found.values), -shift, 0.0006);
    EXPECT_EQ(found.numbers.clock_rate(found.values), 0.0);
    EXPECT_NEAR(found.fit.values[0], true_mass, 0.02);
    EXPECT_NEAR(found.fit.values[1], true_damping, 0.03);
    EXPECT_LT(found.fit.chi_square, 1.3 * static_cast<double>(found.fit.samples()));
  }
}

TEST(LocalNumbers, FindTheRateOfTheClocks) {
  data::Run run = late_start(3);
  for (double& time : run.times) time *= 1.01;  // the camera's clock runs fast
  run.clock.rate_sigma = 0.01;
  const Fitted found = fitted(run);
  ASSERT_EQ(found.numbers.size(), 1u);
  EXPECT_NEAR(found.numbers.clock_rate(found.values), 1.0 / 1.01 - 1.0, 0.001);
}

TEST(LocalNumbers, ComeInTheOrderStateEdgesClocksHum) {
  data::Run run = late_start(4);
  run.start = data::Start::free;
  run.hold = data::InputHold::unknown_within_sample;
  run.clock = {.offset_sigma = 0.01, .rate_sigma = 0.001};
  const DeclaredModel declared = slide(true_mass, true_damping);
  const fit::Hypothesis hypothesis(declared, {});
  PreparedRun prepared = prepare_run(run, declared, hypothesis.model_at(hypothesis.start()));
  prepared.lines = {50.0};
  prepared.line_sizes = {2e-3};
  const Window& window = prepared.windows.front();
  const LocalNumbers numbers(prepared, window);
  const std::size_t edges = window.edges.size();
  EXPECT_EQ(edges, 5u);  // the start, and every half second
  ASSERT_EQ(numbers.size(), 2 + edges + 2 + 4);
  EXPECT_TRUE(numbers.is_state(1));
  EXPECT_FALSE(numbers.is_state(2));
  EXPECT_TRUE(numbers.moves(1 + edges));
  EXPECT_FALSE(numbers.moves(2 + edges));
  // An even distribution over an interval.
  EXPECT_NEAR(numbers.sigma()[2], interval / std::sqrt(12.0), 1e-12);
  EXPECT_EQ(numbers.sigma()[2 + edges], 0.01);
  EXPECT_EQ(numbers.sigma()[3 + edges], 0.001);
  EXPECT_NEAR(numbers.sigma().back(), 6e-3, 1e-15);
  std::vector<double> values(numbers.size());
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<double>(i);
  EXPECT_EQ(numbers.initial_state(values, {}).rates[0], 1.0);
  EXPECT_EQ(numbers.edge_shifts(values).front(), 2.0);
  EXPECT_EQ(numbers.clock_offset(values), static_cast<double>(2 + edges));
  EXPECT_EQ(numbers.clock_rate(values), static_cast<double>(3 + edges));
  EXPECT_EQ(numbers.line_amplitudes(values).front(), static_cast<double>(4 + edges));
}

// The mean of a sine over an exposure T is the sine times sin(w T / 2) / (w T / 2).
TEST(ObservedValues, OfAnExposureAreMeansOverIt) {
  constexpr double frequency = 8.0;
  constexpr double exposure = 0.03;
  constexpr double turn = 2.0 * std::numbers::pi * frequency;
  Trajectory motion;
  for (int i = 0; i <= 600; ++i) {
    const double time = -0.1 + 0.002 * i;
    motion.times.push_back(time);
    motion.states.push_back({.angles = Eigen::VectorXd::Constant(1, std::sin(turn * time)),
                             .rates = Eigen::VectorXd::Constant(1, turn * std::cos(turn * time)),
                             .internal = {}});
  }
  data::Run run = slide_run(90, {}, no_error);
  run.clock.exposure = exposure;
  PreparedRun prepared{.run = &run};
  const Window window{.range = {0, run.samples()}};
  const LocalNumbers none(prepared, window);
  const DeclaredModel declared = slide(true_mass, true_damping);
  const fit::Hypothesis hypothesis(declared, {});
  const Eigen::VectorXd seen = observed_values(hypothesis.model_at(hypothesis.start()), prepared, window, motion,
                                               {.numbers = &none, .values = none.mean()});
  const double gain = std::sin(0.5 * turn * exposure) / (0.5 * turn * exposure);
  EXPECT_LT(gain, 0.91);
  for (std::size_t i = 0; i < run.samples(); ++i)
    EXPECT_NEAR(seen[static_cast<Eigen::Index>(i)], gain * std::sin(turn * run.times[i]), 2e-4) << i;
}

}  // namespace
}  // namespace coilwright::measurement::replay
