#include "coilwright/simulation/blocked_grasp.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>
#include <optional>

#include "coilwright/actuator/hinges.hpp"
#include "simulation/reference.hpp"

namespace coilwright::simulation {
namespace {

using actuator::Configuration;

// All that a finger of two joints has of energy at rest, the coils' work included.
double potential(const Model& model, double current, double first, double second) {
  JointVector angles(2);
  angles << first, second;
  double energy = energy_of(model, {.angles = angles, .rates = straight(model)});
  for (const actuator::HingePair& pair : model.magnetics().hinge_pairs()) {
    const auto torque = [&](double angle) { return pair.torque_per_ampere->value(angle); };
    energy -=
        pair.sense * current * boost::math::quadrature::gauss<double, 15>::integrate(torque, 0.0, angles[pair.joint]);
  }
  return energy;
}

struct Grasp {
  double force;
  double first;
  double second;
};

mechanics::LinkPoint contact_of(const Model& model, const actuator::GraspPoint& grasp) {
  return {.link = model.tip().link, .along = grasp.height.value_or(model.tip().along), .offset = model.tip().offset};
}

// The second joint's angle that puts the contact back on the wall, by bisection.
double on_the_wall(const Model& model, double first, const actuator::GraspPoint& grasp) {
  // x of the contact with both joints at half the opening, written out: the last joint, then the segment beyond it.
  const double half = 0.5 * grasp.opening;
  const mechanics::LinkPoint contact = contact_of(model, grasp);
  const double wall = model.chain().link(0).length * std::sin(half) + contact.along * std::sin(grasp.opening);
  double low = half - 0.5;
  double high = half + 0.5;
  for (int i = 0; i < 60; ++i) {
    JointVector angles(2);
    angles << first, 0.5 * (low + high);
    (model.chain().position(contact, angles).x() < wall ? low : high) = angles[1];
  }
  return 0.5 * (low + high);
}

// The grasp as the least energy along the wall, found by bisection of its slope, and the force as what one more
// micrometre would cost. Central differences of 1e-7 rad, so as not to reach over a stop's kink: 1e-11 of rounding.
Grasp by_least_energy(const Model& model, double current, const actuator::GraspPoint& grasp = {}) {
  constexpr double step = 1e-7;
  const auto along = [&](double first) {
    return potential(model, current, first + step, on_the_wall(model, first + step, grasp)) -
           potential(model, current, first - step, on_the_wall(model, first - step, grasp));
  };
  double low = 0.5 * grasp.opening - 0.1;
  double high = 0.5 * grasp.opening + 0.06;
  for (int i = 0; i < 60; ++i) (along(0.5 * (low + high)) < 0.0 ? low : high) = 0.5 * (low + high);
  const double first = 0.5 * (low + high);
  const double second = on_the_wall(model, first, grasp);
  const double slope =
      (potential(model, current, first, second + step) - potential(model, current, first, second - step)) /
      (2.0 * step);
  JointVector ahead(2);
  JointVector behind(2);
  ahead << first, second + step;
  behind << first, second - step;
  const double tip = (model.chain().position(contact_of(model, grasp), ahead).x() -
                      model.chain().position(contact_of(model, grasp), behind).x()) /
                     (2.0 * step);
  return {.force = -slope / tip, .first = first, .second = second};
}

TEST(BlockedGrasp, IsTheLeastEnergyAlongTheWall) {
  for (const actuator::ContactChoice faces : {actuator::ContactChoice::hard_parts, actuator::ContactChoice::walls}) {
    actuator::Design design = actuator::paper_finger();
    design.choices.faces = faces;
    const Model model = actuator::assemble_or_throw(design).model;
    for (const double current : {0.0, 0.7, 1.4}) {
      const BlockedGrasp grasp = blocked_grasp(model, model.all_coils(current)).value();
      const Grasp least = by_least_energy(model, current);
      EXPECT_NEAR(grasp.force, least.force, 1e-6);
      EXPECT_NEAR(grasp.angles[0], least.first, 1e-6);
      EXPECT_NEAR(grasp.angles[1], least.second, 1e-6);
    }
  }
}

TEST(BlockedGrasp, IsTheLeastEnergyAlongAWallFartherAway) {
  const Model model = actuator::assemble_or_throw(actuator::paper_finger()).model;
  for (const actuator::GraspPoint& grasp :
       {actuator::GraspPoint{.opening = 0.4, .height = {}}, actuator::GraspPoint{.opening = 0.8, .height = 0.017},
        actuator::GraspPoint{.opening = 0.0, .height = 0.019}}) {
    const BlockedGrasp pressed = blocked_grasp(model, model.all_coils(1.4), grasp).value();
    const Grasp least = by_least_energy(model, 1.4, grasp);
    EXPECT_NEAR(pressed.force, least.force, 1e-6);
    EXPECT_NEAR(pressed.angles[0], least.first, 1e-6);
    EXPECT_NEAR(pressed.angles[1], least.second, 1e-6);
  }
}

// The audit's figures of the prototype at 1.4 A, to their digits: 1.12, 0.71, 0.56 and 0.26 N at 0 to 50 degrees of
// opening; and the errata's 1.18 N for a contact at 20 instead of 21.2 mm.
TEST(BlockedGrasp, WeakensAsTheWallStandsFartherAway) {
  const Model model = actuator::assemble_or_throw(actuator::paper_finger()).model;
  const auto force = [&](double degrees, std::optional<double> height) {
    const actuator::GraspPoint grasp{.opening = degrees * std::numbers::pi / 180.0, .height = height};
    return blocked_grasp(model, model.all_coils(1.4), grasp).value().force;
  };
  EXPECT_NEAR(force(0.0, {}), 1.12, 0.005);
  EXPECT_NEAR(force(20.0, {}), 0.71, 0.005);
  EXPECT_NEAR(force(30.0, {}), 0.56, 0.005);
  EXPECT_NEAR(force(50.0, {}), 0.26, 0.005);
  EXPECT_NEAR(force(0.0, 20e-3), 1.18, 0.005);
  // Beyond the steady angle of 63.6 degrees the finger does not reach it.
  EXPECT_EQ(force(70.0, {}), 0.0);
}

// Without the silicone between its faces a joint that magnets hold shut gives way by 2.5 degrees, and half of the force
// is lost. The audit's figures at 1.4 A, to their digits; its 0.61 N of D had 0.9 mm between the two coils.
TEST(BlockedGrasp, OfCAndDNeedsTheirWalls) {
  const auto force = [](Configuration configuration, actuator::ContactChoice faces) {
    actuator::Design design = actuator::with_face_contact(actuator::paper_finger(), faces);
    design.layout = actuator::layout_of(configuration);
    const Model model = actuator::assemble_or_throw(design).model;
    return blocked_grasp(model, model.all_coils(1.4)).value().force;
  };
  EXPECT_NEAR(force(Configuration::C, actuator::ContactChoice::hard_parts), 0.77, 0.005);
  EXPECT_NEAR(force(Configuration::C, actuator::ContactChoice::walls), 1.33, 0.005);
  EXPECT_NEAR(force(Configuration::D, actuator::ContactChoice::hard_parts), 0.61, 0.01);
  EXPECT_NEAR(force(Configuration::D, actuator::ContactChoice::walls), 1.28, 0.01);
}

TEST(BlockedGrasp, RefusesAWallThatIsNowhere) {
  const Model model = actuator::assemble_or_throw(actuator::paper_finger()).model;
  const auto text = [&](const actuator::GraspPoint& grasp) {
    return error_text([&] { (void)blocked_grasp(model, model.all_coils(1.4), grasp); });
  };
  EXPECT_EQ(text({.opening = -0.1, .height = {}}), "grasp opening must be finite and >= 0; got -0.1 rad");
  EXPECT_EQ(text({.opening = 0.0, .height = -0.02}), "grasp height must be finite and >= 0; got -0.02 m");
  EXPECT_EQ(text({.opening = 0.0, .height = 0.03}),
            "grasp height must not lie beyond the tip, 21.2 mm from its joint; got 30 mm");
}

// Bent by b in two joints alike the tip is at x = l1 sin(b / 2) + l2 sin(b). Its slope is no more than zero from
// c = cos(b / 2) with 4 l2 c^2 + l1 c - 2 l2 = 0 on: there the tip has been as far out as it gets, and a wall at its x
// was gone through before. Such walls were once pressed on from behind, without any current too.
TEST(BlockedGrasp, RefusesAWallBehindTheFinger) {
  const Model model = actuator::assemble_or_throw(actuator::paper_finger()).model;
  const double first = model.chain().link(0).length;
  const double second = model.tip().along;
  const double cosine = (-first + std::sqrt(first * first + 32.0 * second * second)) / (8.0 * second);
  const double farthest = 2.0 * std::acos(cosine);
  const auto grasp = [&](double opening) {
    return blocked_grasp(model, model.all_coils(1.4), {.opening = opening, .height = {}});
  };
  EXPECT_EQ(grasp(farthest - 1e-6).value().force, 0.0);
  for (const double opening : {farthest + 1e-6, 2.3, std::numbers::pi, 5.5, 2.0 * std::numbers::pi})
    EXPECT_EQ(error_text([&] { (void)grasp(opening); }),
              fmt::format("grasp opening must be less than {:.4g} deg, from where on the contact comes back from the "
                          "wall that it would touch; got {:.6g} deg",
                          farthest * 180.0 / std::numbers::pi, opening * 180.0 / std::numbers::pi));
}

TEST(BlockedGrasp, IsNoForceWhereTheFingerWouldRatherLeave) {
  for (const Configuration configuration : {Configuration::B, Configuration::C, Configuration::D}) {
    const Model model = finger(configuration).model;
    const BlockedGrasp grasp = blocked_grasp(model, model.all_coils(-1.4)).value();
    EXPECT_EQ(grasp.force, 0.0);
    const double wall = model.chain().position(model.tip(), straight(model)).x();
    EXPECT_LT(model.chain().position(model.tip(), grasp.angles).x(), wall);
  }
}

// In any number of joints: on the wall, in balance with the wall's push, and stronger with more current.
TEST(BlockedGrasp, OfLongFingersBalancesAndGrowsWithCurrent) {
  for (const Configuration configuration : {Configuration::A, Configuration::C, Configuration::D}) {
    const Model model = finger(configuration).model;
    const double wall = model.chain().position(model.tip(), straight(model)).x();
    double before = 0.0;
    for (const double current : {0.0, 0.5, 1.0, 1.4}) {
      const actuator::CoilCurrents currents = model.all_coils(current);
      const auto grasp = blocked_grasp(model, currents);
      ASSERT_TRUE(grasp.has_value()) << model.joints() << " joints, " << current << " A";
      EXPECT_NEAR(model.chain().position(model.tip(), grasp->angles).x(), wall, 1e-9);
      const JointVector push = model.chain().jacobian(model.tip(), grasp->angles).row(0).transpose() * grasp->force;
      EXPECT_LT((model.static_residual(grasp->angles, currents) - push).norm(), 1e-9);
      EXPECT_GT(grasp->force, before);
      before = grasp->force;
    }
  }
}

// A soft hinge and a strong coil: the tip stays on the wall, and the force goes on with the current as before. The wall
// was once stiff against the hinge only, and such a finger went through it.
TEST(BlockedGrasp, HoldsAFingerWhoseCoilsAreFarStrongerThanItsHinges) {
  actuator::Design design;
  design.coil = {.inner_radius = 3e-3, .turns_radial = 21, .turns_axial = 16, .wire_gauge = 32};
  design.magnet.radius = 8.5e-3;
  design.magnet.length = 14e-3;
  design.body.gap = 0.6e-3;
  design.body.bottom_layer = 1.5e-3;
  const Model model = actuator::assemble_or_throw(design).model;
  const auto force = [&](double current) {
    const auto grasp = blocked_grasp(model, model.all_coils(current));
    return grasp ? grasp->force : 0.0;
  };
  const double slope = (force(2.0) - force(1.8)) / 0.2;
  // Angles hardly change (the joints are at their stops or near), so the line holds to a per cent of the rise.
  for (const double current : {2.2, 2.6, 3.0})
    EXPECT_NEAR(force(current), force(2.0) + slope * (current - 2.0), 0.01 * force(2.0)) << current;
}

}  // namespace
}  // namespace coilwright::simulation
