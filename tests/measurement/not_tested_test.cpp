#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "coilwright/formats/data/declared_actuator.hpp"
#include "coilwright/measurement/diagnosis.hpp"
#include "coilwright/simulation/transient.hpp"
#include "measurement/ball_on_a_string.hpp"
#include "measurement/random_numbers.hpp"

// What no motion, torque or current of a record could show is neither named nor ruled out.
namespace coilwright::measurement {
namespace {

using ::testing::Contains;
using ::testing::IsEmpty;
using ::testing::IsSupersetOf;
using ::testing::Not;

constexpr double degree = std::numbers::pi / 180.0;

std::vector<std::string_view> ids_named(const Diagnosis& found) {
  std::vector<std::string_view> out;
  for (const AddedEffect& each : found.effects) out.push_back(each.kind->id());
  return out;
}

std::vector<std::string_view> ids_not_tested(const Diagnosis& found) {
  return identification::ids_of(found.odds.not_tested());
}

Diagnosis diagnosed_on(std::vector<data::Run> runs, const formats::DeclaredActuator& declared) {
  data::Dataset data;
  data.fit = std::move(runs);
  return diagnose(data, declared.model, {.threads = 2});
}

// Once 10 s after the start the swing itself counted as hum of an instrument at rest, and a drag or a hysteresis in its
// spring "explained" what that hid. Where it is let go moving, a delay seemed to show in its first picture.
TEST(NotTested, IsWhatNeedsATorqueInASwingWithoutOne) {
  const Ball balls[] = {{}, {.angle = 0.3, .rate = 4.0}, {.length = 0.1, .angle = 0.5}};
  unsigned seed = 1;
  for (const Ball& ball : balls)
    for (const double duration : {20.0, 30.0}) {
      const Diagnosis found =
          diagnosed_on({ball.filmed(duration, 30.0, ++seed)}, declared_ball(1.006 * ball.length, 0.0));
      EXPECT_EQ(name_of(found.verdict), "no_missing_effect") << ball.length << " m, " << duration << " s";
      EXPECT_THAT(ids_named(found), IsEmpty());
      EXPECT_THAT(ids_not_tested(found), IsSupersetOf({"load_friction", "measurement_delay"}));
      EXPECT_THAT(ids_not_tested(found), Not(Contains("quadratic_drag")));
      ASSERT_EQ(found.calibration.size(), 2u);
      EXPECT_LE(found.calibration[1].lower, ball.length);
      EXPECT_GE(found.calibration[1].upper, ball.length);
    }
}

// The paper's finger with its forces as its formula has them.
const formats::DeclaredActuator& paper_finger() {
  static const std::vector<std::string> calibrated{"joint_stiffness", "joint_damping"};
  static const formats::DeclaredActuator declared = formats::parse_declared_actuator(
      R"({"format": "actuator/1", "configuration": "B", "model": {"torque": "line_of_centres"},
          "coil": {"inner_radius_mm": 3, "turns_radial": 15, "turns_axial": 30, "wire_gauge_AWG": 28},
          "magnet": {"radius_mm": 10, "length_mm": 6, "grade": "N52"},
          "body": {"gap_mm": 0.9, "bottom_layer_mm": 2.5, "side_wall_mm": 1, "bottom_wall_mm": 0.25, "top_wall_mm": 1.25,
                   "front_length_mm": 8.6, "rear_length_mm": 20, "shore_hardness_A": 28},
          "measured": {"joint_stiffness_Nmm_rad": 12.5, "joint_damping_Nmms_rad": 0.129}})",
      "finger.json", {.names = calibrated, .file = "dataset.json", .tolerances = {}});
  return declared;
}

actuator::Model as_declared(const formats::DeclaredActuator& declared) {
  std::vector<double> values;
  for (const replay::CalibrationParameter& each : declared.model.calibration) values.push_back(each.declared);
  return actuator::Model(declared.model.build(values));
}

// It is let go from a bent pose: no current, no torque.
data::Run released_finger(unsigned seed) {
  const actuator::Model model = as_declared(paper_finger());
  data::Run run{.name = "release.csv",
                .kind = data::RunKind::transient,
                .drive = data::Drive::current,
                .start = data::Start::free,
                .sigma = 0.1 * degree};
  for (int i = 0; i < 400; ++i) {
    run.times.push_back(0.005 * i);
    run.inputs.push_back({0.0});
  }
  simulation::State start{.angles = mechanics::JointVector::Constant(model.joints(), 12.0 * degree),
                          .rates = mechanics::JointVector::Zero(model.joints())};
  Normal normal(seed);
  for (int j = 0; j < model.joints(); ++j)
    run.channels.push_back(
        {.name = fmt::format("theta{}_deg", j + 1), .kind = data::ChannelKind::joint_angle, .joint = j});
  for (const simulation::State& state :
       simulation::simulate(model, simulation::model_input(model, run.command()), start))
    for (int j = 0; j < model.joints(); ++j)
      run.channels[static_cast<std::size_t>(j)].values.push_back(state.angles[j] + 0.1 * degree * normal());
  return run;
}

TEST(NotTested, IsWhatACurrentDoesInARecordWithoutOne) {
  const Diagnosis found = diagnosed_on({released_finger(1)}, paper_finger());
  EXPECT_THAT(ids_named(found), IsEmpty());
  EXPECT_THAT(ids_not_tested(found),
              IsSupersetOf({"driver_deadband", "driver_saturation", "coil_heating", "coil_lag", "off_axis_force",
                            "force_gain", "magnet_heating", "measurement_delay"}));
  EXPECT_THAT(ids_not_tested(found), Not(Contains("dry_friction")));
  // A bias flows without a command.
  EXPECT_THAT(ids_not_tested(found), Not(Contains("current_offset")));
}

// Of a bench with so many readings at angles up to 20 degrees; of a torque, at currents up to 1 A.
data::Run bench(data::RunKind kind, const actuator::Model& model, unsigned seed) {
  data::Run run{.name = "bench.csv", .kind = kind, .sigma = 1e-5};
  run.channels = {{.name = "torque_Nmm", .kind = data::ChannelKind::torque}};
  Normal normal(seed);
  for (int i = 0; i < 40; ++i) {
    mechanics::JointVector pose = mechanics::JointVector::Zero(model.joints());
    pose[0] = 0.5 * degree * i;
    run.angles.push_back(pose[0]);
    const double current = 0.25 * (1 + i % 4);
    if (kind == data::RunKind::static_torque) run.inputs.push_back({current});
    const double torque = kind == data::RunKind::static_torque
                              ? model.magnetic_torques(pose, model.all_coils(current))[0]
                              : -model.hinge_torques(pose)[0];
    run.channels.front().values.push_back(torque + *run.sigma * normal());
  }
  return run;
}

// Each effect of the catalogue is left out of at least one of these records, and named in none.
TEST(NotTested, IsEveryEffectSomewhere) {
  std::set<std::string_view> untested;
  const auto look_at = [&](const Diagnosis& found) {
    EXPECT_THAT(ids_named(found), IsEmpty());
    for (const std::string_view id : ids_not_tested(found)) untested.insert(id);
    for (const identification::Posterior::Inclusion& each : found.odds.effects())
      EXPECT_THAT(ids_not_tested(found), Not(Contains(each.effect)));
  };
  const formats::DeclaredActuator arm = formats::parse_declared_actuator(
      R"({"format": "lumped-model/1", "gravity_m_s2": 9.81,
          "links": [{"length_m": 0.3, "com_along_m": 0.15, "com_offset_m": 0, "mass_kg": 0.2, "inertia_kgm2": 1e-3},
                    {"length_m": 0.3, "com_along_m": 0.15, "com_offset_m": 0, "mass_kg": 0.2, "inertia_kgm2": 1e-3}],
          "joints": [{"stiffness_Nm_rad": 0.1, "damping_Nms_rad": 1e-3},
                     {"stiffness_Nm_rad": 0.1, "damping_Nms_rad": 1e-3}]})",
      "arm.json", {.names = {}, .file = "dataset.json", .tolerances = {}});
  for (const formats::DeclaredActuator* rig : {&paper_finger(), &arm})
    look_at(diagnosed_on({bench(data::RunKind::joint_stiffness, as_declared(*rig), 1)}, *rig));
  look_at(diagnosed_on({bench(data::RunKind::static_torque, as_declared(paper_finger()), 2)}, paper_finger()));
  for (const actuator::EffectKind* kind : actuator::standard_effects().kinds())
    EXPECT_TRUE(untested.contains(kind->id())) << kind->id();
}

}  // namespace
}  // namespace coilwright::measurement
