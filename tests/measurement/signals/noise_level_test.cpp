#include "coilwright/measurement/signals/noise_level.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "degree.hpp"
#include "error_text.hpp"
#include "measurement/random_numbers.hpp"

namespace coilwright::measurement::signals {
namespace {

using std::numbers::pi;
using testing::HasSubstr;

data::Run record(const std::vector<double>& times, const std::function<double(double)>& motion, double sigma,
                 double step, std::uint64_t seed) {
  Normal normal(seed);
  data::Channel channel{.name = "bending_angle_deg"};
  for (const double t : times) {
    const double value = motion(t) + sigma * normal();
    channel.values.push_back(step > 0.0 ? step * std::round(value / step) : value);
  }
  return {.name = "run.csv", .times = times, .channels = {channel}};
}

std::vector<double> evenly(double rate, int samples) {
  std::vector<double> times;
  for (int i = 0; i < samples; ++i) times.push_back(i / rate);
  return times;
}

double estimated(const data::Run& run) {
  return noise_of(run, run.channels.front()).sigma;
}

// Mean and spread over forty records of 1200 samples: a single estimate scatters by 1 / sqrt(2 n) = 2 % and more.
struct Ratio {
  double mean{};
  double spread{};
};
Ratio ratio_to_truth(const std::function<double(double)>& motion) {
  // Rounding adds step^2 / 12 to the variance.
  const double truth = degree * std::hypot(0.3, 0.02 / std::sqrt(12.0));
  constexpr int records = 40;
  double sum = 0.0;
  double squares = 0.0;
  for (int seed = 1; seed <= records; ++seed) {
    const double ratio = estimated(record(evenly(500.0, 1200), motion, 0.3 * degree, 0.02 * degree, seed)) / truth;
    sum += ratio;
    squares += (ratio - 1.0) * (ratio - 1.0);
  }
  return {sum / records, std::sqrt(squares / records)};
}

// 1200 samples: 2.0 % at best. 1.5 times that allows for the choice of the window and for forty records.
constexpr double spread_of_one = 0.032;

TEST(Noise, IsFoundUnderASineOfTenHertz) {
  for (const double amplitude : {0.0, 1.0, 30.0}) {
    const Ratio ratio = ratio_to_truth([&](double t) { return amplitude * degree * std::sin(2.0 * pi * 10.0 * t); });
    EXPECT_NEAR(ratio.mean, 1.0, 0.012) << amplitude;
    EXPECT_LT(ratio.spread, spread_of_one) << amplitude;
  }
}

TEST(Noise, IsFoundUnderSlowSines) {
  for (const double frequency : {0.5, 1.0, 2.0, 5.0}) {
    const Ratio ratio = ratio_to_truth([&](double t) { return 0.8 * std::sin(2.0 * pi * frequency * t); });
    EXPECT_NEAR(ratio.mean, 1.0, 0.012) << frequency;
    EXPECT_LT(ratio.spread, spread_of_one) << frequency;
  }
}

// A second-order step response, 5 Hz, 8 % damping, with its kink of the acceleration at the onset.
double step_response(double t) {
  if (t < 0.2) return 0.0;
  const double phase = 2.0 * pi * 5.0 * (t - 0.2);
  return 1.0 - std::exp(-0.08 * phase) * (std::cos(phase) + 0.08 * std::sin(phase));
}

TEST(Noise, IsFoundUnderAStepThatOscillates) {
  const Ratio ratio = ratio_to_truth(step_response);
  EXPECT_NEAR(ratio.mean, 1.0, 0.012);
  EXPECT_LT(ratio.spread, spread_of_one);
}

TEST(Noise, IsRobustAgainstImpacts) {
  // A bounce on a stop: the speed jumps ten times in the record.
  const Ratio ratio = ratio_to_truth([](double t) { return std::abs(0.7 * std::sin(2.0 * pi * 2.1 * t)); });
  EXPECT_NEAR(ratio.mean, 1.0, 0.015);
  EXPECT_LT(ratio.spread, 0.04);  // narrower windows: of nine samples 3.2 % at best
}

TEST(Noise, IsFoundUnderFastMotionSampledSlowly) {
  // 20 Hz at 285 Hz is fourteen samples a turn: only narrow windows are smooth, and they know less.
  const data::Run run = record(
      evenly(285.0, 3000), [](double t) { return std::sin(2.0 * pi * 20.0 * t); }, 0.002, 0.0, 7);
  EXPECT_NEAR(estimated(run) / 0.002, 1.0, 0.10);
}

TEST(Noise, AllowsUnevenSampling) {
  Normal normal(3);
  std::vector<double> times{0.0};
  while (times.size() < 2000) times.push_back(times.back() + 0.002 * (0.5 + normal.uniform()));
  for (std::size_t i = 1000; i < times.size(); ++i) times[i] += 0.3;  // a gap
  const data::Run run = record(
      times, [](double t) { return 0.5 * std::sin(2.0 * pi * 10.0 * t); }, 0.005, 0.0, 4);
  EXPECT_NEAR(estimated(run) / 0.005, 1.0, 0.05);
}

TEST(Noise, IsNeverBelowTheQuantisation) {
  const double step = 0.00038;
  const data::Run run = record(
      evenly(285.0, 2000), [](double t) { return std::round(4.0 * t); }, 0.0, step, 1);
  EXPECT_GE(estimated(run), step / std::sqrt(12.0) * (1.0 - 1e-9));
  const data::Run moving = record(
      evenly(1000.0, 4000), [](double t) { return std::sin(2.0 * pi * 0.7 * t); }, 0.0, 1e-6, 1);
  // Uniform in a step, which is no normal law: trimming costs nothing, the shape of it a few per cent.
  EXPECT_NEAR(estimated(moving) / (1e-6 / std::sqrt(12.0)), 1.0, 0.08);
}

TEST(Noise, IsTheGivenOneIfThereIsOne) {
  data::Run run = record(
      evenly(500.0, 100), [](double) { return 0.0; }, 1.0, 0.0, 1);
  run.sigma = 0.25;
  const NoiseLevel level = noise_of(run, run.channels.front());
  EXPECT_EQ(level.sigma, 0.25);
  EXPECT_TRUE(level.given);
  EXPECT_EQ(level.source, "given");
  EXPECT_EQ(level.run, "run.csv");
  EXPECT_EQ(level.channel, "bending_angle_deg");
}

// Five currents, nine angles: a bowed torque curve of 40 N mm with 0.5 N mm of noise.
data::Run bench(std::uint64_t seed) {
  Normal normal(seed);
  data::Run run{.name = "bench.csv", .kind = data::RunKind::static_torque};
  data::Channel channel{.name = "torque_Nmm", .kind = data::ChannelKind::torque};
  for (int a = 0; a < 9; ++a)
    for (const double current : {0.35, 0.7, 1.05, 1.4, -0.7}) {
      const double angle = 7.5 * degree * a;
      run.angles.push_back(angle);
      run.inputs.push_back({current});
      channel.values.push_back(current * 0.04 / (1.0 + 2.0 * angle) + 0.0005 * normal());
    }
  run.channels = {channel};
  return run;
}

TEST(Noise, OfABenchComesFromNeighboursAtTheSameCurrent) {
  double sum = 0.0;
  constexpr int benches = 40;
  for (int seed = 1; seed <= benches; ++seed) sum += std::pow(estimated(bench(seed)) / 0.0005, 2);
  // 45 samples in five curves of nine: each estimate is good to 20 %, their mean over forty to 3 %.
  EXPECT_NEAR(std::sqrt(sum / benches), 1.0, 0.12);
  EXPECT_THAT(noise_of(bench(1), bench(1).channels.front()).source, HasSubstr("differences of order"));
}

TEST(Noise, OfVeryFewSamplesIsAssumed) {
  data::Run run{.name = "gauge.csv", .kind = data::RunKind::blocked_force};
  run.inputs = {{0.5}, {1.0}};
  run.channels = {{.name = "force_N", .values = {0.5, 1.0}}};
  const NoiseLevel level = noise_of(run, run.channels.front());
  EXPECT_THAT(level.source, HasSubstr("assumed"));
  EXPECT_GT(level.sigma, 0.0);
}

TEST(Noise, OfEvenlySpacedReadingsIsNotTheirSpacing) {
  Normal normal(5);
  data::Run run{.name = "gauge.csv", .kind = data::RunKind::joint_stiffness};
  data::Run rounded = run;
  data::Channel channel{.name = "torque_Nmm"};
  data::Channel on_grid = channel;
  for (int a = 0; a < 12; ++a) {
    run.angles.push_back(0.1 * a);
    channel.values.push_back(0.0125 * 0.1 * a + 2e-6 * normal());
    on_grid.values.push_back(1e-4 * std::round(0.0125 * 0.1 * a / 1e-4));  // steps of 1.2 to 1.3 mm, read to 0.1
  }
  rounded.angles = run.angles;
  run.channels = {channel};
  rounded.channels = {on_grid};
  EXPECT_NEAR(estimated(run) / 2e-6, 1.0, 0.7);  // ten differences: 30 %
  EXPECT_NEAR(estimated(rounded) / (1e-4 / std::sqrt(12.0)), 1.0, 0.7);
}

TEST(Noise, OfAConstantReadingIsStillPositive) {
  const data::Run run = record(
      evenly(500.0, 100), [](double) { return 0.0; }, 0.0, 0.0, 1);
  EXPECT_GT(estimated(run), 0.0);
}

TEST(Noise, OfRepeatedMeasurementsComesFromTheRepeats) {
  Normal normal(9);
  data::Run run{.name = "gauge.csv", .kind = data::RunKind::joint_stiffness};
  data::Channel channel{.name = "torque_Nmm"};
  for (int a = 0; a < 10; ++a)
    for (int repeat = 0; repeat < 10; ++repeat) {
      run.angles.push_back(0.1 * a);
      channel.values.push_back((a % 2 ? 1.0 : -1.0) + 0.01 * normal());
    }
  run.channels = {channel};
  // About eighty contrasts inside a place, correlated: 13 %. Across places the values jump by two hundred times that.
  EXPECT_NEAR(estimated(run) / 0.01, 1.0, 0.35);
}

TEST(Noise, RefusesAColumnOfAnotherLength) {
  data::Run run = record(
      evenly(500.0, 100), [](double) { return 0.0; }, 1.0, 0.0, 1);
  run.channels.front().values.pop_back();
  EXPECT_EQ(error_text([&] { (void)noise_of(run, run.channels.front()); }),
            "run.csv: column bending_angle_deg must have one value for each sample of the run; got 99");
}

}  // namespace
}  // namespace coilwright::measurement::signals
