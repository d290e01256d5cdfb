#include "measurement/identification/rig_scale.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "coilwright/measurement/data/dataset.hpp"
#include "measurement/slider_model.hpp"

namespace coilwright::measurement::identification {
namespace {

constexpr double frequency = 5.0;  // Hz
constexpr double angular = 2.0 * std::numbers::pi * frequency;
constexpr double amplitude = 0.3;
constexpr double moving = 2.0;  // s; then it rests as long

// A mass on a spring, and how it swings.
replay::DeclaredModel swing() {
  replay::DeclaredModel declared = slide(1.0, 0.0);
  declared.build = [free = declared.build](std::span<const double> values) {
    actuator::ModelSpec spec = free(values);
    spec.hinges.front().stiffness = angular * angular;
    return spec;
  };
  return declared;
}

data::Run swung(double frame_rate) {
  data::Run run{.name = "swing.csv",
                .kind = data::RunKind::transient,
                .drive = data::Drive::torque,
                .sigma = noise_sigma,
                .channels = {{.name = "theta1_rad", .kind = data::ChannelKind::joint_angle}}};
  for (std::size_t i = 0; static_cast<double>(i) < 2.0 * moving * frame_rate; ++i) {
    const double time = static_cast<double>(i) / frame_rate;
    run.times.push_back(time);
    run.inputs.push_back({0.0});
    run.channels.front().values.push_back(time < moving ? amplitude * std::sin(angular * time) : 0.0);
  }
  return run;
}

// A finger filmed at 30 pictures a second moves no slower: twenty of them are four of these periods.
TEST(RigScale, TheRateIsThatOfTheMotionAtAnyFrameRate) {
  // The root mean square of a cosine, over a record of which half is rest.
  const double rate = amplitude * angular * std::sqrt(0.5 * 0.5);
  for (const double frame_rate : {500.0, 120.0, 60.0, 30.0}) {
    const data::Run run = swung(frame_rate);
    const replay::DeclaredModel declared = swing();
    const actuator::Model model(declared.build(std::vector{1.0, 0.0}));
    const std::vector<replay::PreparedRun> runs{replay::prepare_run(run, declared, model)};
    EXPECT_NEAR(rig_scale(runs, model).rate, rate, 0.1 * rate) << frame_rate << " Hz";
  }
}

}  // namespace
}  // namespace coilwright::measurement::identification
