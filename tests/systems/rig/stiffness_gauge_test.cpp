#include "coilwright/systems/rig/stiffness_gauge.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "actuator/paper_finger.hpp"
#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "degree.hpp"

namespace coilwright::systems::rig {
namespace {

using actuator::Design;
using testing::ThrowsMessage;

constexpr auto line_of_centres = magnetics::Fidelity::line_of_centres;

Design finger_with_stiffness(double stiffness) {
  Design design = actuator::paper_geometry();
  actuator::Measured measured = actuator::paper_measured();
  measured.joint_stiffness = stiffness;
  design.calibration = actuator::calibrate(design, measured);
  return design;
}

TEST(StiffnessGauge, RecoversTheStiffnessThatWasPutIn) {
  for (const double stiffness : {12.5e-3, 9.7e-3}) {
    const StiffnessReadings all = readings(finger_with_stiffness(stiffness), paper_stiffness_gauge());
    ASSERT_EQ(all.points.size(), 6U);
    // The paper's finger: 21.2 mm from joint 2 to its tip.
    EXPECT_NEAR(all.arm, 21.2e-3, 1e-12);
    const StiffnessSpread level = spread(all, &StiffnessPoint::level, line_of_centres);
    EXPECT_NEAR(level.mean, stiffness, 1e-12 * stiffness);
    EXPECT_NEAR(level.deviation, 0.0, 1e-14);
    for (const StiffnessPoint& point : all.points)
      EXPECT_NEAR(point.level.exact.force, stiffness * point.angle / 21.2e-3, 1e-12);
  }
}

// The second row of the paper's (12) by hand, with joint 1 straight: m2 g (l2 sin - h cos), Table II.
TEST(StiffnessGauge, ReadsTheWeightOfTheLastSegmentWhereTheFingerHangs) {
  const StiffnessReadings all = readings(actuator::paper_finger(), paper_stiffness_gauge());
  for (const StiffnessPoint& point : all.points) {
    const double weight = 22.5e-3 * 9.81 * (9.1e-3 * std::sin(point.angle) - 11.5e-3 * std::cos(point.angle));
    EXPECT_NEAR(point.hanging.exact.stiffness, 12.5e-3 + weight / point.angle, 1e-12);
    EXPECT_NEAR(point.hanging.exact.force, (12.5e-3 * point.angle + weight) / 21.2e-3, 1e-12);
  }
}

// k (1 + beta angle^2) at every angle: the gauge shows a hinge that stiffens by a spread that a straight one has not.
TEST(StiffnessGauge, ShowsAHingeThatStiffens) {
  Design design = actuator::paper_finger();
  design.effects = {{.kind = actuator::standard_effects().find("stiffness_hardening"), .values = {0.4}}};
  const StiffnessReadings all = readings(design, {.angles = {0.3, 1.1}});
  for (const StiffnessPoint& point : all.points)
    EXPECT_NEAR(point.level.line_of_centres.stiffness, 12.5e-3 * (1.0 + 0.4 * point.angle * point.angle), 1e-12);
}

// Joint 1 has the magnet's segment of 7.2 mm in its arm, too.
TEST(StiffnessGauge, TakesAnyJointAndPlaceOfTheGauge) {
  const StiffnessReadings tip = readings(actuator::paper_finger(), {.angles = {0.3}, .joint = 0});
  EXPECT_NEAR(tip.arm, 28.4e-3, 1e-12);
  const StiffnessReadings lower = readings(actuator::paper_finger(), {.angles = {0.3}, .joint = 0, .height = 10e-3});
  EXPECT_NEAR(lower.arm, 17.2e-3, 1e-12);
  EXPECT_NEAR(lower.points[0].level.exact.force, 12.5e-3 * 0.3 / 17.2e-3, 1e-12);
  EXPECT_NEAR(lower.points[0].level.exact.stiffness, 12.5e-3, 1e-14);
}

// In C the two magnets pull at each other without any current, and an opened joint takes them apart.
TEST(StiffnessGauge, FeelsMagnetsThatActOnEachOther) {
  Design design = actuator::paper_finger();
  design.layout = actuator::layout_of(actuator::Configuration::C);
  const StiffnessReadings all = readings(design, {.angles = {0.2}, .joint = 1});
  EXPECT_NEAR(all.points[0].hinge_torque, 12.5e-3 * 0.2, 1e-12);
  EXPECT_GT(all.points[0].level.exact.stiffness, 2.0 * 12.5e-3);
}

TEST(StiffnessGauge, RefusesWhatNoGaugeCanHold) {
  const Design finger = actuator::paper_finger();
  const auto refusal = [&](const StiffnessGauge& gauge) { return [&, gauge] { return readings(finger, gauge); }; };
  EXPECT_THAT(refusal({.angles = {}}),
              ThrowsMessage<std::invalid_argument>("there must be at least one of the angles"));
  EXPECT_THAT(refusal({.angles = {0.0}}),
              ThrowsMessage<std::invalid_argument>("angle must be > 0 and at most 120 deg; got 0 deg"));
  EXPECT_THAT(refusal({.angles = {121.0 * degree}}),
              ThrowsMessage<std::invalid_argument>("angle must be > 0 and at most 120 deg; got 121 deg"));
  EXPECT_THAT(refusal({.angles = {0.1}, .joint = 2}),
              ThrowsMessage<std::invalid_argument>("joint must be from 1 to 2; got 3"));
  EXPECT_THAT(refusal({.angles = {0.1}, .height = 22e-3}),
              ThrowsMessage<std::invalid_argument>(
                  "gauge height must not lie beyond the tip, 21.2 mm from its joint; got 22 mm"));
}

}  // namespace
}  // namespace coilwright::systems::rig
