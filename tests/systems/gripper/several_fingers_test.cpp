#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "coilwright/systems/gripper/grasp.hpp"
#include "degree.hpp"

namespace coilwright::systems::gripper {
namespace {

using Eigen::Vector3d;
using mechanics::JointVector;

Gripper gripper_of(int fingers, Polarity polarity = Polarity::same, double spacing = 0.07) {
  return {actuator::Design{}, {.angle = 30.0 * degree, .spacing = spacing, .polarity = polarity, .fingers = fingers}};
}

Object ball_of_mass(double mass) {
  return {.shape = ObjectShape::sphere, .width = 0.06, .mass = mass, .friction = 0.8, .centre = {0.0, -0.016}};
}

// Energy of point dipoles, J, one in place of each magnet of all fingers, all bent alike. The magnets of a finger by
// itself are left out: their energy does not depend on the other fingers.
double dipole_energy(const Gripper& gripper, const JointVector& angles) {
  const actuator::Design design;
  constexpr double mu0 = 4e-7 * std::numbers::pi;
  const double moment = design.magnet.remanence / mu0 * std::numbers::pi * design.magnet.radius * design.magnet.radius *
                        design.magnet.length;
  struct Dipole {
    int finger;
    Vector3d centre, moment;
  };
  std::vector<Dipole> all;
  const int count = gripper.mounting().fingers;
  const mechanics::LinkFrames frames = gripper.finger().chain().frames(angles);
  // The base is turned outwards: against the side to which the joints open, about the axis out of the plane.
  const Eigen::Rotation2Dd outwards(-gripper.mounting().angle);
  for (int k = 0; k < count; ++k) {
    const Eigen::AngleAxisd round(2.0 * std::numbers::pi * k / count, Vector3d::UnitY());
    const double turned = gripper.mounting().polarity == Polarity::opposite && k % 2 == 1 ? -1.0 : 1.0;
    for (const FingerMagnet& magnet : gripper.magnets()) {
      const mechanics::LinkFrame& frame = frames[static_cast<std::size_t>(magnet.centre.link) + 1];
      const Eigen::Vector2d at = outwards * frame.at(magnet.centre.along, magnet.centre.offset);
      const Eigen::Vector2d axis = outwards * frame.axis();
      all.push_back({k, round * Vector3d(at.x() - 0.5 * gripper.mounting().spacing, at.y(), 0.0),
                     turned * magnet.sense * moment * (round * Vector3d(axis.x(), axis.y(), 0.0))});
    }
  }
  double energy = 0.0;
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = i + 1; j < all.size(); ++j) {
      if (all[i].finger == all[j].finger) continue;
      const Vector3d between = all[j].centre - all[i].centre;
      const double distance = between.norm();
      const Vector3d direction = between / distance;
      energy += 1e-7 / std::pow(distance, 3) *
                (all[i].moment.dot(all[j].moment) - 3.0 * all[i].moment.dot(direction) * all[j].moment.dot(direction));
    }
  return energy;
}

// A metre apart magnets are dipoles, and all fingers together lose the energy that their torques give.
void expect_torques_of_the_energy(int fingers, Polarity polarity) {
  const Gripper gripper = gripper_of(fingers, polarity, 1.0);
  JointVector angles = JointVector::Constant(gripper.finger().joints(), 25.0 * degree);
  const JointVector torques = gripper.magnet_torques(angles, angles).left;
  constexpr double step = 1e-4;
  const auto last_with_a_magnet = gripper.magnets().back().centre.link;
  for (Eigen::Index j = 0; j <= last_with_a_magnet; ++j) {
    JointVector more = angles;
    JointVector less = angles;
    more[j] += step;
    less[j] -= step;
    const double expected = -(dipole_energy(gripper, more) - dipole_energy(gripper, less)) / (2.0 * step) / fingers;
    EXPECT_NEAR(torques[j] / expected, 1.0, 0.02) << fingers << " fingers, joint " << j;
  }
}

TEST(SeveralFingers, FeelTheMagnetsOfAllOthers) {
  for (const int fingers : {2, 3, 4, 5, 6}) expect_torques_of_the_energy(fingers, Polarity::same);
  for (const int fingers : {2, 4, 6}) expect_torques_of_the_energy(fingers, Polarity::opposite);
}

// 140 mm apart the magnets hardly count: each finger of three carries as each of two does.
TEST(SeveralFingers, CarryAShareEach) {
  Object wide = ball_of_mass(0.02);
  wide.width = 0.12;
  const GraspTask task{.current = 1.4};
  const Grasp two = grasp(gripper_of(2, Polarity::same, 0.14), wide, task);
  wide.mass = 0.03;
  const Grasp three = grasp(gripper_of(3, Polarity::same, 0.14), wide, task);
  ASSERT_TRUE(two.both_touched);
  ASSERT_TRUE(three.both_touched);
  EXPECT_NEAR(three.load / two.load, 1.5, 1e-12);
  EXPECT_NEAR(three.capacity / two.capacity, 1.5, 0.005);
  ASSERT_EQ(three.contacts.size(), two.contacts.size());
  for (std::size_t i = 0; i < two.contacts.size(); ++i)
    EXPECT_NEAR(three.contacts[i].normal / two.contacts[i].normal, 1.0, 5e-3);
}

TEST(SeveralFingers, HoldACupAsTwoHoldABoxOfItsWidth) {
  Object cup = ball_of_mass(0.02);
  cup.shape = ObjectShape::upright_cylinder;
  cup.width = 0.05;
  cup.height = 0.06;
  Object box = cup;
  box.shape = ObjectShape::box;
  const GraspTask task{.current = 1.4};
  EXPECT_NEAR(grasp(gripper_of(2), cup, task).capacity, grasp(gripper_of(2), box, task).capacity, 1e-3);
  EXPECT_GT(grasp(gripper_of(3), cup, task).capacity, 1.3 * grasp(gripper_of(2), cup, task).capacity);
}

template <class Call>
std::string error_text(const Call& call) {
  try {
    call();
  } catch (const std::exception& error) {
    return error.what();
  }
  return {};
}

TEST(SeveralFingers, SayWhatTheyCannotDo) {
  EXPECT_EQ(error_text([] { gripper_of(1); }), "mounting.fingers must be between 2 and 8; got 1");
  EXPECT_EQ(error_text([] { gripper_of(3, Polarity::opposite); }),
            "mounting.fingers must be an even number where every second one is turned (polarity opposite); got 3");
  EXPECT_THAT(
      error_text([] { gripper_of(8, Polarity::same, 0.05); }),
      testing::MatchesRegex("mounting.spacing must leave 8 straight fingers, 22 mm wide, beside each other; got "
                            "50 mm, where neighbours overlap by .* mm"));
  Object beside = ball_of_mass(0.05);
  beside.centre.x() = 0.003;
  EXPECT_EQ(error_text([&] { (void)grasp(gripper_of(3), beside, {.current = 1.4}); }),
            "object must be a sphere or an upright_cylinder with its centre on the gripper's axis for more than two "
            "fingers; got a sphere with its centre at 3 mm");
  // Round a small ball six fingers that hang straight have no room.
  Object small = ball_of_mass(0.002);
  small.width = 0.03;
  const Gripper six(actuator::Design{}, {.angle = 0.0, .spacing = 0.055, .fingers = 6});
  EXPECT_THAT(error_text([&] { (void)grasp(six, small, {.current = 1.4}); }),
              testing::MatchesRegex("the 6 fingers must leave each other room around the object; got .* mm of overlap "
                                    "between neighbours"));
}

}  // namespace
}  // namespace coilwright::systems::gripper
