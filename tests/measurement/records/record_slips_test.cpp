#include "measurement/records/record_slips.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "coilwright/measurement/records/record_slip.hpp"
#include "measurement/declared_finger.hpp"
#include "measurement/fit/hypothesis.hpp"
#include "measurement/random_numbers.hpp"
#include "measurement/replay/prediction.hpp"

namespace coilwright::measurement::records {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

// What the declared finger shows on a bench.
data::Run measured(data::Run run) {
  const replay::DeclaredModel& declared = finger().model;
  const fit::Hypothesis as_declared(declared, {});
  const actuator::Model model = as_declared.model_at(as_declared.start());
  const std::size_t samples = std::max(run.inputs.size(), run.angles.size());
  run.channels.front().values.assign(samples, 0.0);
  const replay::PreparedRun prepared{.run = &run};
  const auto values = replay::predict_bench(model, prepared, declared);
  run.channels.front().values.assign(values->begin(), values->end());
  return run;
}

data::Run wall() {
  data::Run run{.name = "wall.csv", .kind = data::RunKind::blocked_force};
  for (int i = 2; i <= 14; i += 2) run.inputs.push_back({0.1 * i});
  run.channels = {{.name = "force_N", .kind = data::ChannelKind::force}};
  return measured(run);
}

data::Run torque_bench() {
  data::Run run{.name = "bench.csv", .kind = data::RunKind::static_torque};
  for (int i = 0; i <= 60; i += 10) {
    run.angles.push_back(degree * i);
    run.inputs.push_back({0.7});
  }
  run.channels = {{.name = "torque_Nmm", .kind = data::ChannelKind::torque}};
  return measured(run);
}

data::Run gauge() {
  data::Run run{.name = "gauge.csv", .kind = data::RunKind::joint_stiffness};
  for (int i = 5; i <= 40; i += 5) run.angles.push_back(degree * i);
  run.channels = {{.name = "torque_Nmm", .kind = data::ChannelKind::torque}};
  return measured(run);
}

data::Run hot() {
  data::Run run{.name = "hot.csv", .kind = data::RunKind::temperature};
  for (int i = 0; i <= 60; ++i) {
    run.times.push_back(10.0 * i);
    run.inputs.push_back({1.0});
  }
  run.channels = {{.name = "temperature_degC", .kind = data::ChannelKind::temperature}};
  return measured(run);
}

std::vector<data::Run> benches() {
  return {wall(), torque_bench(), gauge(), hot()};
}

// As another unit would have it: the value, in that of memory, `times` as large, and more by `plus`.
data::Run with_readings(data::Run run, double times, double plus = 0.0) {
  for (double& value : run.channels.front().values) value = times * value + plus;
  return run;
}

// The refusal; empty where there is none.
std::string refusal(const data::Run& run) {
  try {
    require_no_slip(std::vector{run}, finger().model);
  } catch (const RecordSlip& slip) {
    return slip.what();
  }
  return "";
}

// "wall.csv: force_N: looks like ...; name the column force_gf"
void expect_slip(const data::Run& run, const std::string& start, const std::string& end) {
  const std::string text = refusal(run);
  EXPECT_EQ(text.substr(0, start.size()), start) << text;
  EXPECT_TRUE(text.ends_with(end)) << text;
}

TEST(RecordSlips, OfABenchNameRunColumnAndUnit) {
  constexpr double gravity = 9.80665;
  expect_slip(with_readings(wall(), 1e3 / gravity), "wall.csv: force_N: looks like grams, ",
              "; name the column force_gf");
  expect_slip(with_readings(wall(), 1.0 / gravity), "wall.csv: force_N: looks like kilograms, ",
              "; name the column force_kgf");
  expect_slip(with_readings(wall(), 1.0 / 4.44822), "wall.csv: force_N: looks like pounds-force",
              "; name the column force_lbf");
  expect_slip(with_readings(wall(), 1e3), "wall.csv: force_N: looks like mN", "; name the column force_mN");
  expect_slip(with_readings(torque_bench(), 1e-3),
              "bench.csv: torque_Nmm: looks like Nm:", "; name the column torque_Nm");
  expect_slip(with_readings(torque_bench(), 1.0 / 98.0665), "bench.csv: torque_Nmm: looks like kgfcm",
              "; name the column torque_kgfcm");
  expect_slip(with_readings(gauge(), 1.0 / 0.0980665), "gauge.csv: torque_Nmm: looks like gfcm",
              "; name the column torque_gfcm");
  expect_slip(with_readings(gauge(), -1.0), "gauge.csv: torque_Nmm: looks like one that is counted the other way",
              "; turn its sign");
  expect_slip(with_readings(hot(), 1.0, 273.15), "hot.csv: temperature_degC: looks like kelvin",
              "; name the column temperature_K");
  expect_slip(with_readings(hot(), 1.8, 32.0), "hot.csv: temperature_degC: looks like degrees Fahrenheit",
              "; name the column temperature_degF");
}

TEST(RecordSlips, OfACurrentAnAngleOrATimeAreFoundOnABench) {
  for (data::Run run : {wall(), torque_bench(), hot()}) {
    for (auto& row : run.inputs) row.front() *= 1e3;
    expect_slip(run, run.name + ": current_A: looks like milliamperes", "; name the column current_mA");
  }
  data::Run bench = torque_bench();
  for (double& angle : bench.angles) angle /= degree;
  expect_slip(bench, "bench.csv: angle_rad: looks like degrees", "; name the column angle_deg");
  data::Run minutes = hot();
  for (double& time : minutes.times) time /= 60.0;
  expect_slip(minutes, "hot.csv: time_s: looks like minutes", "; name the column time_min");
}

TEST(RecordSlips, AreFoundWhereTheModelIsOffByHalf) {
  EXPECT_NE(refusal(with_readings(wall(), 1.4 / 9.80665)), "");
  EXPECT_NE(refusal(with_readings(torque_bench(), 0.4e-3)), "");
  EXPECT_NE(refusal(with_readings(gauge(), 2.5e-3)), "");
  // A room of 18 degC, and twice the rise, under an actuator that has 25.
  data::Run run = hot();
  for (double& value : run.channels.front().values) value = 32.0 + 1.8 * (18.0 + 2.0 * (value - 25.0));
  EXPECT_NE(refusal(run), "");
}

TEST(RecordSlips, AreNoneOfWhatAnActuatorMayDo) {
  Normal normal(5);
  for (const data::Run& bench : benches()) {
    const std::vector<double>& values = bench.channels.front().values;
    const bool temperature = bench.kind == data::RunKind::temperature;
    const double zero = temperature ? 25.0 : 0.0;
    EXPECT_EQ(refusal(bench), "");
    for (const double factor : {0.3, 0.5, 2.0, 3.0, 3.4})
      EXPECT_EQ(refusal(with_readings(bench, factor, zero * (1.0 - factor))), "") << bench.name << ' ' << factor;
    double size = 0.0;
    for (const double value : values) size = std::max(size, std::abs(value - zero));
    for (const double of_size : {0.1, 1.0, 9.8, 1000.0}) {
      if (!temperature) {
        EXPECT_EQ(refusal(with_readings(bench, 1.0, of_size * size)), "") << "bias " << of_size;
      }
      data::Run noisy = bench;
      for (double& value : noisy.channels.front().values) value += of_size * size * normal();
      EXPECT_EQ(refusal(noisy), "") << "noise " << of_size;
    }
  }
}

// A gauge of which the silicone hardens: three times the torque at the end of it.
TEST(RecordSlips, AreNoneOfAShapeThatTheModelLacks) {
  data::Run run = gauge();
  for (std::size_t i = 0; i < run.angles.size(); ++i)
    run.channels.front().values[i] *= 1.0 + 2.0 * std::pow(run.angles[i] / run.angles.back(), 2);
  EXPECT_EQ(refusal(run), "");
}

}  // namespace
}  // namespace coilwright::measurement::records
