#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "measurement/fit/fit.hpp"
#include "measurement/slider_model.hpp"

namespace coilwright::measurement::fit {
namespace {

constexpr double stiffness = 5000.0;
constexpr double damping = 24.0;
constexpr double force = 500.0;
constexpr double release = 15.0;  // s

// The slide on a spring, which swings at 8 Hz.
replay::DeclaredModel on_a_spring(double declared_stiffness, double declared_damping) {
  replay::DeclaredModel declared = slide(declared_stiffness, declared_damping);
  declared.calibration.front().key = "stiffness";
  declared.build = [free = declared.build](std::span<const double> values) {
    actuator::ModelSpec spec = free(std::array{true_mass, values[1]});
    spec.hinges.front().stiffness = values[0];
    return spec;
  };
  return declared;
}

// Where it is at `time` if it was held off by a force and let go: the solution in closed form.
double let_go(double time) {
  const double held = force / stiffness;
  if (time <= release) return held;
  const double decay = 0.5 * damping / true_mass;
  const double frequency = std::sqrt(stiffness / true_mass - decay * decay);
  const double since = time - release;
  return held * std::exp(-decay * since) *
         (std::cos(frequency * since) + decay / frequency * std::sin(frequency * since));
}

// One second of its swinging after fifteen of rest, by a camera whose clock runs slow or fast by `rate`.
data::Run held_and_let_go(double rate, std::uint64_t seed) {
  data::Run run{.name = "hold.csv",
                .kind = data::RunKind::transient,
                .drive = data::Drive::torque,
                .sigma = noise_sigma,
                .channels = {{.name = "theta1_rad", .kind = data::ChannelKind::joint_angle}}};
  run.clock.rate_sigma = 0.004;
  Normal normal(seed);
  for (int i = 0; i < 1920; ++i) {
    const double time = i / 120.0;
    run.times.push_back(time / (1.0 + rate));
    run.channels.front().values.push_back(let_go(time) + noise_sigma * normal());
  }
  run.input_times = {0.0, release, 17.0};
  run.inputs = {{force}, {0.0}, {0.0}};
  return run;
}

// 0.9 % of fifteen seconds is more than a swing: from the rate 0 a fit ends on the wrong one, its damper far off.
TEST(ClockRates, AreFoundOnTheRightSwing) {
  for (const double rate : {-0.009, -0.005, 0.005, 0.009}) {
    const replay::DeclaredModel declared = on_a_spring(1.06 * stiffness, 0.8 * damping);
    const data::Run run = held_and_let_go(rate, 5);
    const Hypothesis hypothesis(declared, {});
    const std::vector<replay::PreparedRun> runs{
        replay::prepare_run(run, declared, hypothesis.model_at(hypothesis.start()))};
    const auto found = fit({.hypothesis = &hypothesis, .runs = runs, .start = hypothesis.start()});
    ASSERT_TRUE(found.has_value());
    EXPECT_NEAR(found->runs.front().local_numbers.front().back(), rate, 1e-4) << rate;
    EXPECT_NEAR(found->values[0] / stiffness, 1.0, 0.01) << rate;
    EXPECT_NEAR(found->values[1] / damping, 1.0, 0.1) << rate;
  }
}

}  // namespace
}  // namespace coilwright::measurement::fit
