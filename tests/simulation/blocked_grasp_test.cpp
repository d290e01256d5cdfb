#include "coilwright/simulation/blocked_grasp.hpp"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

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

// The second joint's angle that puts the tip back on the wall, by bisection.
double on_the_wall(const Model& model, double first) {
  const double wall = model.chain().position(model.tip(), straight(model)).x();
  double low = -0.5;
  double high = 0.5;
  for (int i = 0; i < 60; ++i) {
    JointVector angles(2);
    angles << first, 0.5 * (low + high);
    (model.chain().position(model.tip(), angles).x() < wall ? low : high) = angles[1];
  }
  return 0.5 * (low + high);
}

// The grasp as the least energy along the wall, found by bisection of its slope, and the force as what one more
// micrometre would cost. Central differences of 1e-7 rad, so as not to reach over a stop's kink: 1e-11 of rounding.
Grasp by_least_energy(const Model& model, double current) {
  constexpr double step = 1e-7;
  const auto along = [&](double first) {
    return potential(model, current, first + step, on_the_wall(model, first + step)) -
           potential(model, current, first - step, on_the_wall(model, first - step));
  };
  double low = -0.06;
  double high = 0.06;
  for (int i = 0; i < 60; ++i) (along(0.5 * (low + high)) < 0.0 ? low : high) = 0.5 * (low + high);
  const double first = 0.5 * (low + high);
  const double second = on_the_wall(model, first);
  const double slope =
      (potential(model, current, first, second + step) - potential(model, current, first, second - step)) /
      (2.0 * step);
  JointVector ahead(2);
  JointVector behind(2);
  ahead << first, second + step;
  behind << first, second - step;
  const double tip =
      (model.chain().position(model.tip(), ahead).x() - model.chain().position(model.tip(), behind).x()) / (2.0 * step);
  return {.force = -slope / tip, .first = first, .second = second};
}

TEST(BlockedGrasp, IsTheLeastEnergyAlongTheWall) {
  for (const actuator::FaceContact faces : {actuator::FaceContact::hard_parts, actuator::FaceContact::walls}) {
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

}  // namespace
}  // namespace coilwright::simulation
