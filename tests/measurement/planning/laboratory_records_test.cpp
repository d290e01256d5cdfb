// Synthetic records with the faults of a laboratory: clocks, exposure, coloured noise, outliers, changed rigs.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "coilwright/actuator/assemble.hpp"
#include "coilwright/measurement/planning/synthetic_data.hpp"
#include "degree.hpp"
#include "measurement/planning/apply_instrument.hpp"

namespace coilwright::measurement::planning {
namespace {

using std::numbers::pi;

const actuator::Assembly& default_finger() {
  static const actuator::Assembly assembly = actuator::assemble_or_throw({});
  return assembly;
}

replay::DeclaredModel default_rig() {
  return {.calibration = {}, .build = [](std::span<const double>) { return default_finger().model.nominal_spec(); }};
}

PlannedRun run_of(InputShape input, double rate = 200.0) {
  PlannedRun run{.plan = {.name = "a.csv", .kind = data::RunKind::transient, .drive = data::Drive::current},
                 .input = std::move(input),
                 .duration = 0.8,
                 .rate = rate};
  run.plan.channels = {{.name = "bending_angle_deg", .kind = data::ChannelKind::bending_angle}};
  return run;
}

data::Run record(const PlannedRun& run, std::uint64_t seed = 3, const Instruments& instruments = {}) {
  return simulate_experiment({.name = "x", .instruments = instruments, .runs = {run}}, default_rig(), {}, seed).at(0);
}

const InputShape slow_sine = SineShape{.amplitude = 0.5, .offset = 0.7, .frequency = 3.0};

// A fine record holds its input for 0.1 ms, and so it is half of that behind the shape.
constexpr double behind = 0.5e-4;

// Angles of a fine record at other times, by straight lines: 0.1 ms apart, they miss the curve by 1e-6 rad.
double at(const data::Run& fine, double time) {
  const double place = std::clamp(time, 0.0, fine.times.back()) * 10'000.0;
  const auto i = std::min(static_cast<std::size_t>(place), fine.times.size() - 2);
  const std::vector<double>& values = fine.channels[0].values;
  return std::lerp(values[i], values[i + 1], place - static_cast<double>(i));
}

TEST(LaboratoryRecords, ShowTheMotionAsEarlyOrLateAsTheirClocksAre) {
  const data::Run fine = record(run_of(slow_sine, 10'000.0));
  PlannedRun planned = run_of(slow_sine);
  planned.plan.clock = {.offset_sigma = 0.01, .rate_sigma = 0.01};
  planned.input_rate = 1000.0;
  const TrueClock clock = true_clocks({.name = "x", .instruments = {}, .runs = {planned}}, 3).at(0);
  EXPECT_NE(clock.shift, 0.0);
  EXPECT_NE(clock.rate, 0.0);
  const data::Run run = record(planned);
  ASSERT_TRUE(run.has_input_clock());
  EXPECT_LE(run.input_times.front(), -0.04);
  EXPECT_GE(run.input_times.back(), 0.84);
  double largest = 0.0;
  for (std::size_t i = 0; i < run.samples(); ++i) {
    const double time = run.times[i] * (1.0 + clock.rate) + clock.shift;
    if (time < 0.0 || time > fine.times.back()) continue;
    EXPECT_NEAR(run.channels[0].values[i], at(fine, time + behind), 0.002 * degree) << i;
    largest = std::max(largest, std::abs(run.channels[0].values[i] - at(fine, run.times[i])));
  }
  EXPECT_GT(largest, 0.3 * degree);  // what a reader without the shift would be off by
}

TEST(LaboratoryRecords, AreMeansOverTheExposure) {
  const data::Run fine = record(run_of(slow_sine, 10'000.0));
  PlannedRun planned = run_of(slow_sine);
  planned.plan.clock.exposure = 0.03;
  planned.plan.hold = data::InputHold::linear;
  const data::Run run = record(planned);
  for (std::size_t i = 10; i + 10 < run.samples(); ++i) {
    double mean = 0.0;
    for (int k = 0; k < 60; ++k) mean += at(fine, run.times[i] + behind + ((k + 0.5) / 60.0 - 0.5) * 0.03) / 60.0;
    EXPECT_NEAR(run.channels[0].values[i], mean, 0.01 * degree) << i;  // Simpson's rule over 30 ms at 3 Hz
  }
}

TEST(LaboratoryRecords, HaveEdgesBetweenTheSamplesOfTheInput) {
  PlannedRun planned = run_of(StepShape{.before = 0.0, .after = 1.0, .at = 0.1085}, 60.0);
  planned.plan.hold = data::InputHold::unknown_within_sample;
  const data::Run run = record(planned);
  const data::Run fine = record(run_of(StepShape{.before = 0.0, .after = 1.0, .at = 0.1085}, 10'000.0));
  EXPECT_EQ(run.inputs[6][0], 0.0);  // at 0.1 s
  EXPECT_EQ(run.inputs[7][0], 1.0);  // at 0.1167 s
  for (std::size_t i = 0; i < run.samples(); ++i)
    EXPECT_NEAR(run.channels[0].values[i], at(fine, run.times[i]), 0.005 * degree) << i;
}

TEST(LaboratoryRecords, AreOfTheRigAsItWasChanged) {
  const InputShape nothing = StepShape{};
  const auto first = [](const data::Run& run) { return run.channels[0].values.front(); };
  PlannedRun planned = run_of(nothing);
  const double rest = first(record(planned));
  planned.plan.rig.base_turn = 0.5;
  EXPECT_GT(std::abs(first(record(planned)) - rest), 5.0 * degree);
  planned.plan.rig = {.tip_mass = 5e-3};
  EXPECT_GT(std::abs(first(record(planned)) - rest), 0.5 * degree);
  // An open coil carries nothing of the command.
  planned = run_of(StepShape{.before = 0.0, .after = 1.0, .at = 0.1});
  planned.plan.rig.coil = data::CoilWiring::open;
  const data::Run open = record(planned);
  for (const double value : open.channels[0].values) EXPECT_NEAR(value, rest, 1e-6);
  EXPECT_EQ(open.inputs.back().at(0), 1.0);  // what the log says
}

TEST(LaboratoryRecords, OfStillRunsRest) {
  PlannedRun planned{.plan = {.name = "still.csv", .kind = data::RunKind::still}, .duration = 1.0, .rate = 60.0};
  planned.plan.channels = {{.name = "bending_angle_deg", .kind = data::ChannelKind::bending_angle},
                           {.name = "omega1_rad_s", .kind = data::ChannelKind::joint_rate}};
  const data::Run run = record(planned);
  EXPECT_TRUE(run.inputs.empty());
  EXPECT_EQ(run.samples(), 61u);
  const double rest = record(run_of(StepShape{})).channels[0].values.front();
  for (const double value : run.channels[0].values) EXPECT_NEAR(value, rest, 1e-9);
  for (const double value : run.channels[1].values) EXPECT_EQ(value, 0.0);
}

TEST(LaboratoryRecords, HaveANoisyInputColumnAndAMotionOfTheTrueOne) {
  const data::Run clean = record(run_of(slow_sine));
  const data::Run noisy = record(run_of(slow_sine), 3, {.input_noise = 0.02});
  EXPECT_EQ(noisy.channels[0].values, clean.channels[0].values);
  double square = 0.0;
  for (std::size_t i = 0; i < clean.inputs.size(); ++i)
    square += std::pow(noisy.inputs[i][0] - clean.inputs[i][0], 2) / static_cast<double>(clean.inputs.size());
  EXPECT_NEAR(std::sqrt(square), 0.02, 0.004);  // 161 draws: 5.6 % of it, three times and a half
}

// 20,000 samples at 200 Hz.
std::vector<double> noise(const Instrument& instrument, std::uint64_t seed = 1) {
  std::vector<double> times(20'000);
  for (std::size_t i = 0; i < times.size(); ++i) times[i] = static_cast<double>(i) / 200.0;
  return apply_instrument(instrument, {.seed = seed}, times, std::vector<double>(times.size(), 0.0));
}

double power_at(const std::vector<double>& values, double frequency) {
  double c = 0.0, s = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double phase = 2.0 * pi * frequency * static_cast<double>(i) / 200.0;
    c += values[i] * std::cos(phase);
    s += values[i] * std::sin(phase);
  }
  return (c * c + s * s) / static_cast<double>(values.size());
}

// Mean power over a band of 200 lines.
double band(const std::vector<double>& values, double from) {
  double sum = 0.0;
  for (int i = 0; i < 200; ++i) sum += power_at(values, from * (1.0 + 0.001 * i)) / 200.0;
  return sum;
}

double rms(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

TEST(NoiseOfInstruments, HasItsColourAndItsDeviation) {
  // Independent lines: a mean of 200 of them is within 7 % (one sigma); four of that and the fall over the band.
  const std::vector<double> low =
      noise({.noise = 0.3, .colour = {.kind = NoiseColour::Kind::low_pass, .frequency = 5.0}});
  EXPECT_NEAR(rms(low), 0.3, 0.02);
  EXPECT_NEAR(band(low, 1.0) / band(low, 20.0), (1.0 + 16.0) / (1.0 + 0.04) * 1.2, 6.0);
  const std::vector<double> pink = noise({.noise = 0.3, .colour = {.kind = NoiseColour::Kind::one_over_f}});
  EXPECT_NEAR(band(pink, 1.0) / band(pink, 16.0), 16.0, 6.0);
  const std::vector<double> white = noise({.noise = 0.3});
  EXPECT_NEAR(band(white, 1.0) / band(white, 20.0), 1.0, 0.4);
}

TEST(NoiseOfInstruments, HumsAtOneFrequency) {
  const std::vector<double> hum = noise({.hum = 0.2, .hum_frequency = 50.0});
  EXPECT_NEAR(rms(hum), 0.2 / std::sqrt(2.0), 1e-3);
  EXPECT_NEAR(power_at(hum, 50.0), 0.25 * 0.04 * 20'000.0, 1.0);
}

TEST(NoiseOfInstruments, HasOutliersOfTheirShareAndSize) {
  const std::vector<double> values = noise({.outlier_share = 0.02, .smallest_outlier = 3.0, .largest_outlier = 10.0});
  int count = 0, positive = 0;
  for (const double value : values) {
    if (value == 0.0) continue;
    ++count;
    positive += value > 0.0 ? 1 : 0;
    EXPECT_GE(std::abs(value), 3.0);
    EXPECT_LE(std::abs(value), 10.0);
  }
  EXPECT_NEAR(count, 400, 80);  // four standard deviations
  EXPECT_NEAR(positive, count / 2, 45);
}

}  // namespace
}  // namespace coilwright::measurement::planning
