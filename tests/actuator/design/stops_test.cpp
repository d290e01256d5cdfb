#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "actuator/paper_finger.hpp"
#include "coilwright/actuator/assemble.hpp"

namespace coilwright::actuator {
namespace {

struct Core {
  double half_pitch;
  double half_length;
  double radius;
};

Core core_of(const Design& design, const Dimensions& size, int component) {
  if (design.layout[static_cast<std::size_t>(component)].kind == ComponentKind::magnet)
    return {size.magnet_half_pitch, 0.5 * design.magnet.length, design.magnet.radius};
  return {size.coil_half_pitch, 0.5 * size.coil_length, size.coil_outer_radius};
}

// Clearance between the cores on both sides of a joint at the top of the smaller one, m, from their corners.
double clearance(const Design& design, const Dimensions& size, int joint, double angle) {
  const Core near = core_of(design, size, joint);
  const Core far = core_of(design, size, joint + 1);
  const double height = size.axis_offset + std::min(near.radius, far.radius);
  const mechanics::PlanarChain pair(std::vector<mechanics::Link>{{.length = 1.0, .mass = 1.0, .inertia = 1.0}});
  mechanics::JointVector turned(1);
  turned << angle;
  const auto top_near =
      pair.position({.link = -1, .along = near.half_length - near.half_pitch, .offset = height}, turned);
  const auto top_far = pair.position({.link = 0, .along = far.half_pitch - far.half_length, .offset = height}, turned);
  return top_near.y() - top_far.y();
}

// Configuration D is where it matters: two coils stand 0.6 mm apart, not 0.9.
TEST(HardParts, TouchAtTheAngleAtWhichEachJointStops) {
  for (const Configuration configuration : {Configuration::B, Configuration::C, Configuration::D}) {
    Design design = paper_finger();
    design.layout = layout_of(configuration);
    const Assembly a = assemble_or_throw(design);
    for (int j = 0; j < a.model.joints(); ++j) {
      EXPECT_NEAR(clearance(design, a.dimensions, j, 0.0), gap_of_joint(design, j), 1e-12);
      const double closed = a.model.hinges()[static_cast<std::size_t>(j)].contact.closing_angle;
      // To first order in the angle, 2.5 degrees: the next term is a thousandth.
      EXPECT_NEAR(clearance(design, a.dimensions, j, closed), 0.0, 2e-3 * gap_of_joint(design, j)) << "joint " << j;
    }
  }
}

TEST(GapOfJoint, IsTwoThirdsBetweenTwoCoils) {
  Design design = paper_finger();
  design.layout = layout_of(Configuration::D);
  EXPECT_NEAR(gap_of_joint(design, 1), 0.9e-3, 1e-15);
  EXPECT_NEAR(gap_of_joint(design, 2), 0.6e-3, 1e-15);
  const Dimensions size = dimensions(design);
  EXPECT_NEAR(closing_angle_of_joint(design, size, 0), size.closing_angle, 1e-15);
  EXPECT_NEAR(closing_angle_of_joint(design, size, 2), 0.6e-3 / (11.5e-3 + size.coil_outer_radius), 1e-15);
}

// k = E w H^3 / (3 t): half as stiff again where the walls between two coils are two thirds as thick.
TEST(Walls, AreStifferWhereTheyAreThinner) {
  Design design = paper_finger();
  design.layout = layout_of(Configuration::D);
  const Assembly a = assemble_or_throw(design);
  const auto& hinges = a.model.hinges();
  ASSERT_LT(a.dimensions.coil_outer_radius, design.magnet.radius);  // so all joints' faces have the coil's height
  EXPECT_NEAR(hinges[2].contact.stiffness / hinges[1].contact.stiffness, 1.5, 1e-12);
}

}  // namespace
}  // namespace coilwright::actuator
