#include "measurement/replay/local_numbers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "measurement/fit/fit.hpp"
#include "measurement/fit/residual_blocks.hpp"
#include "measurement/replay/prediction.hpp"
#include "measurement/slider_model.hpp"

namespace coilwright::measurement::replay {
namespace {

constexpr std::size_t still_samples = 20;

// The slide rests for 0.2 s before it is pushed. The force has a clock of its own.
data::Run late_start(std::uint64_t seed, double noise = noise_sigma) {
  data::Run run = slide_run(250, {}, no_error);
  Normal normal(seed);
  std::vector<double>& values = run.channels.front().values;
  values.insert(values.begin(), still_samples, 0.0);
  run.inputs.insert(run.inputs.begin(), still_samples, {0.0});
  run.times.clear();
  for (std::size_t i = 0; i < values.size(); ++i) {
    run.times.push_back(interval * static_cast<double>(i));
    values[i] += noise * normal();
  }
  run.input_times = run.times;
  return run;
}

struct Fitted {
  LocalNumbers numbers{};
  std::vector<double> values{};
  fit::Fit fit{};
};

Fitted fitted(const data::Run& run, double mass = true_mass, double damping = true_damping) {
  const DeclaredModel declared = slide(mass, damping);
  const fit::Hypothesis hypothesis(declared, {});
  const std::vector<PreparedRun> runs{prepare_run(run, declared, hypothesis.model_at(hypothesis.start()))};
  auto found = fit::fit({.hypothesis = &hypothesis, .runs = runs, .start = hypothesis.start()});
  EXPECT_TRUE(found.has_value());
  Fitted out{.numbers = LocalNumbers(runs.front(), runs.front().windows.front()), .fit = found.value()};
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

TEST(InputEdge, LiesBetweenItsSamplesForEveryNumber) {
  const InputEdge edge{.half_width = 0.005};
  EXPECT_EQ(edge.shift(0.0), 0.0);
  for (const double number : {-30.0, -2.0, -0.3, 0.3, 2.0, 30.0}) {
    EXPECT_LT(std::abs(edge.shift(number)), edge.half_width);
    EXPECT_NEAR(edge.number(edge.shift(number)), number, 1e-10 * std::abs(std::pow(number, 3.0)) + 1e-12);
    const double step = 1e-5 * (1.0 + std::abs(number));
    const double slope = (edge.shift(number + step) - edge.shift(number - step)) / (2.0 * step);
    EXPECT_NEAR(edge.slope(number) / slope, 1.0, 1e-6) << number;
  }
}

// Of standard normal numbers: as many in each tenth of the way, but the outermost, within a factor of two.
TEST(InputEdge, IsAboutAsLikelyEverywhereBetweenItsSamples) {
  const InputEdge edge{.half_width = 1.0};
  Normal normal(6);
  std::vector<int> tenths(20);
  constexpr int draws = 200000;
  for (int i = 0; i < draws; ++i) ++tenths[static_cast<std::size_t>(10.0 * (1.0 + edge.shift(normal())))];
  for (std::size_t i = 1; i + 1 < tenths.size(); ++i) {
    const double share = tenths[i] / (draws / 20.0);
    EXPECT_GT(share, 0.75) << i;
    EXPECT_LT(share, 1.5) << i;
  }
}

// Every force of this record changes at a sample, the last place of an edge between it and the one before. The fit
// starts with a slide that is far off.
TEST(LocalNumbers, FindEdgesThatLieAtASample) {
  data::Run run = late_start(5, 0.1 * noise_sigma);
  run.sigma = 0.1 * noise_sigma;
  run.hold = data::InputHold::unknown_within_sample;
  const Fitted found = fitted(run, 1.4 * true_mass, 0.5 * true_damping);
  EXPECT_LT(found.fit.chi_square, 1.2 * static_cast<double>(found.fit.samples()));
  EXPECT_NEAR(found.fit.values[0], true_mass, 0.02);
  EXPECT_NEAR(found.fit.values[1], true_damping, 0.03);
  // When the camera took its pictures is not known to the millisecond either: together they say when the force changed.
  const InputEdge edge{.half_width = 0.5 * interval};
  for (const double number : found.numbers.edge_numbers(found.values))
    EXPECT_NEAR(edge.shift(number) - found.numbers.clock_offset(found.values), 0.5 * interval, 0.06 * interval);
}

// Wherever an edge is, and also taken over from where it was before.
TEST(LocalNumbers, HaveDerivativesByTheirPlaceWhereAnEdgeIsNextToASample) {
  data::Run run = late_start(5);
  run.hold = data::InputHold::unknown_within_sample;
  const DeclaredModel declared = slide(true_mass, true_damping);
  const fit::Hypothesis hypothesis(declared, {});
  const std::vector<PreparedRun> runs{prepare_run(run, declared, hypothesis.model_at(hypothesis.start()))};
  const Eigen::VectorXd start = hypothesis.start();
  fit::FitRequest request{.hypothesis = &hypothesis, .runs = runs, .start = start};
  const auto known = fit::evaluate_with_jacobian(request);
  ASSERT_TRUE(known.has_value());
  for (const bool taken_over : {false, true}) {
    request.derivatives_from = taken_over ? &*known : nullptr;
    fit::ResidualBlocks blocks(request);
    for (const double number : {-5.0, -0.8, 0.8, 5.0}) {
      std::ranges::fill(blocks.local_numbers(), 0.1);
      blocks.local_numbers()[1] = number;
      const Eigen::VectorXd column =
          blocks.evaluate(start, fit::Derivatives::by_local_numbers).value().blocks[0].local_jacobian.col(1);
      const double step = 1e-2 * (1.0 + number * number);
      const auto residuals_at = [&](double displaced) -> Eigen::VectorXd {
        blocks.local_numbers()[1] = displaced;
        return blocks.evaluate(start, fit::Derivatives::none).value().blocks[0].residuals;
      };
      const Eigen::VectorXd expected = (residuals_at(number + step) - residuals_at(number - step)) / (2.0 * step);
      EXPECT_LT((column - expected).norm(), (taken_over ? 0.15 : 0.01) * expected.norm()) << number << taken_over;
    }
  }
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
  EXPECT_EQ(numbers.sigma()[2], 1.0);
  EXPECT_EQ(numbers.edge_of(1), std::nullopt);
  EXPECT_EQ(numbers.edge_of(2), 0u);
  EXPECT_EQ(numbers.edge_of(1 + edges), edges - 1);
  EXPECT_EQ(numbers.edge_of(2 + edges), std::nullopt);
  EXPECT_EQ(numbers.sigma()[2 + edges], 0.01);
  EXPECT_EQ(numbers.sigma()[3 + edges], 0.001);
  EXPECT_NEAR(numbers.sigma().back(), 6e-3, 1e-15);
  std::vector<double> values(numbers.size());
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<double>(i);
  EXPECT_EQ(numbers.initial_state(values, {}).rates[0], 1.0);
  EXPECT_EQ(numbers.edge_numbers(values).front(), 2.0);
  EXPECT_EQ(numbers.clock_offset(values), static_cast<double>(2 + edges));
  EXPECT_EQ(numbers.clock_rate(values), static_cast<double>(3 + edges));
  EXPECT_EQ(numbers.line_amplitudes(values).front(), static_cast<double>(4 + edges));
}

TEST(LocalNumbers, LeaveTheErrorsOfAnInputToAModelThatIsFarWorse) {
  const DeclaredModel declared = slide(true_mass, true_damping);
  const fit::Hypothesis hypothesis(declared, {});
  const data::Run run = slide_run(100, {}, no_error);
  PreparedRun prepared = prepare_run(run, declared, hypothesis.model_at(hypothesis.start()));
  Window& window = prepared.windows.front();
  window.errors.resize(3);
  const std::size_t others = LocalNumbers(prepared, window).size() - 3;
  prepared.model_error = 9.0;
  EXPECT_EQ(LocalNumbers(prepared, window).size(), others + 3);
  prepared.model_error = 10.0;
  const LocalNumbers numbers(prepared, window);
  EXPECT_EQ(numbers.size(), others);
  EXPECT_TRUE(numbers.input_errors(numbers.mean()).empty());
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
