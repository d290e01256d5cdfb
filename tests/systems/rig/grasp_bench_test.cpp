#include "coilwright/systems/rig/grasp_bench.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "actuator/paper_finger.hpp"
#include "coilwright/actuator/assemble.hpp"
#include "coilwright/magnetics/axial_force.hpp"

namespace coilwright::systems::rig {
namespace {

using actuator::Design;
using testing::ThrowsMessage;

// The errata's own computation (tests/data/actuator_SOURCES.md): 0.142 N of weight without current and 1.12 N at 1.4 A;
// 1.18 N where the finger touches at 20 mm. The paper measured 0.14 and 1.19 N.
TEST(GraspBench, ReadsWhatTheErrataHave) {
  const auto tip = readings(actuator::paper_finger(), {.currents = {0.0, 1.4}});
  EXPECT_NEAR(tip[0].force.line_of_centres, 0.142, 5e-4);
  EXPECT_NEAR(tip[1].force.line_of_centres, 1.12, 5e-3);
  const auto lower = readings(actuator::paper_finger(), {.currents = {1.4}, .grasp = {.height = 20e-3}});
  EXPECT_NEAR(lower[0].force.line_of_centres, 1.18, 5e-3);
}

// One joint on a wall that it just touches when straight: the force on its lever is what repels, and the weight of the
// segment, whose centre hangs h in front of the joint. All by hand but the coaxial force, which is measured against
// independent cases in tests/magnetics.
TEST(GraspBench, BalancesAFingerOfOneJoint) {
  Design design = actuator::paper_geometry();
  design.layout = actuator::layout_of(actuator::Configuration::A);
  const actuator::Assembly assembly = actuator::assemble_or_throw(design);
  const magnetics::ThickCoil coil({.inner_radius = design.coil.inner_radius,
                                   .outer_radius = assembly.dimensions.coil_outer_radius,
                                   .length = assembly.dimensions.coil_length,
                                   .turns_radial = 15,
                                   .turns_axial = 30,
                                   .winding = magnetics::CurrentDistribution::paper_shells});
  const magnetics::CylinderMagnet magnet({.radius = 10e-3, .length = 6e-3, .remanence = 1.44});
  const double distance = assembly.dimensions.coil_half_pitch + assembly.dimensions.magnet_half_pitch;
  const double arm = assembly.dimensions.axis_offset;
  for (const GraspBenchPoint& point : readings(design, {.currents = {0.0, 0.55, 1.4}})) {
    const double push = -magnetics::axial_force(coil, 1.0, magnet, distance) * point.current;
    const double weight = assembly.segments[1].mass * 9.81;
    const double by_hand = (push + weight) * arm / assembly.dimensions.tip_length;
    EXPECT_NEAR(point.force.line_of_centres, by_hand, 1e-5 * by_hand);
    EXPECT_NEAR(point.force.exact, by_hand, 1e-5 * by_hand);
    EXPECT_NEAR(point.bending.exact, 0.0, 1e-9);
  }
}

TEST(GraspBench, ReadsNothingWhereTheFingerDoesNotReachTheWall) {
  const auto points = readings(actuator::paper_finger(), {.currents = {0.1}, .grasp = {.opening = 1.2}});
  EXPECT_EQ(points[0].force.exact, 0.0);
  EXPECT_LT(points[0].bending.exact, 1.2);
}

TEST(GraspBench, RefusesWhatIsNoNumberAndAContactBeyondTheTip) {
  const Design finger = actuator::paper_finger();
  EXPECT_THAT([&] { return readings(finger, GraspBench{.currents = {}}); },
              ThrowsMessage<std::invalid_argument>("there must be at least one of the currents"));
  EXPECT_THAT([&] { return readings(finger, GraspBench{.currents = {std::numeric_limits<double>::infinity()}}); },
              ThrowsMessage<std::invalid_argument>("current must be finite; got inf A"));
  EXPECT_THAT([&] { return readings(finger, GraspBench{.currents = {1.0}, .grasp = {.height = 30e-3}}); },
              ThrowsMessage<std::invalid_argument>(
                  "grasp height must not lie beyond the tip, 21.2 mm from its joint; got 30 mm"));
}

}  // namespace
}  // namespace coilwright::systems::rig
