#include "coilwright/simulation/equilibrium.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "degree.hpp"
#include "simulation/reference.hpp"

namespace coilwright::simulation {
namespace {

using actuator::Configuration;
using mechanics::JointMatrix;

double softest(const Model& model, const JointVector& angles, const actuator::CoilCurrents& currents) {
  const Eigen::SelfAdjointEigenSolver<JointMatrix> solver(model.tangent_stiffness(angles, currents));
  return solver.eigenvalues()[0];
}

// Where a chain in thick oil ends: the gradient flow, by small explicit steps of a few millionths of a radian per N m.
JointVector in_thick_oil(const Model& model, const actuator::CoilCurrents& currents, JointVector angles) {
  double stiffest = 0.0;
  for (const actuator::Hinge& hinge : model.hinges()) stiffest = std::max(stiffest, hinge.contact.stiffness);
  const double mobility = 0.5 / (stiffest + 1.0);
  for (int i = 0; i < 400'000; ++i) angles += mobility * model.static_residual(angles, currents);
  return angles;
}

JointVector pose(std::initializer_list<double> degrees) {
  JointVector out(static_cast<Eigen::Index>(degrees.size()));
  int j = 0;
  for (const double value : degrees) out[j++] = value * degree;
  return out;
}

TEST(FindEquilibrium, LeavesNoTorqueAndIsStable) {
  for (const Configuration configuration : {Configuration::A, Configuration::B, Configuration::C, Configuration::D}) {
    const Model model = finger(configuration).model;
    for (const double current : {-1.4, 0.0, 0.6, 1.4}) {
      const actuator::CoilCurrents currents = model.all_coils(current);
      const auto found = find_equilibrium(model, currents, straight(model));
      ASSERT_TRUE(found.has_value()) << model.joints() << " joints, " << current << " A";
      EXPECT_LE(model.static_residual(*found, currents).norm(), 1e-11 * torque_scale(model));
      EXPECT_GT(softest(model, *found, currents), 0.0);
    }
  }
}

TEST(FindEquilibrium, FollowsAChainThatCreepsInThickOil) {
  struct Case {
    Configuration configuration;
    double current;
    JointVector start;
  };
  const Case cases[] = {{Configuration::B, 1.4, pose({0.0, 0.0})},
                        {Configuration::B, 0.9, pose({70.0, -1.0})},
                        {Configuration::B, -0.8, pose({40.0, 25.0})},
                        {Configuration::C, 1.2, pose({20.0, 14.0, 17.0, 22.0})},
                        {Configuration::D, 0.7, pose({25.0, 3.0, 9.0, 6.0, 31.0})}};
  for (const Case& one : cases) {
    const Model model = finger(one.configuration).model;
    const actuator::CoilCurrents currents = model.all_coils(one.current);
    const auto found = find_equilibrium(model, currents, one.start);
    ASSERT_TRUE(found.has_value());
    const JointVector crept = in_thick_oil(model, currents, one.start);
    // What is left of the creep after that time: its slowest rate is a ten-thousandth of its fastest.
    EXPECT_LT((*found - crept).lpNorm<Eigen::Infinity>(), 1e-6) << crept.transpose();
  }
}

TEST(FindEquilibrium, StopsAtTheFacesWhenCoilsAttract) {
  const Model model = finger(Configuration::B).model;
  const JointVector angles = find_equilibrium(model, model.all_coils(-1.4), straight(model)).value();
  for (int j = 0; j < 2; ++j) {
    const double closing = model.hinges()[static_cast<std::size_t>(j)].contact.closing_angle;
    EXPECT_LT(angles[j], closing);
    EXPECT_GT(angles[j], closing - 0.05 * degree);
  }
}

// A spring that pushes its joint away faster than it holds has nowhere to rest below half a turn.
TEST(FindEquilibrium, IsNothingWhereAJointFolds) {
  const Model folding =
      with_hinges(finger(Configuration::B).model, [](actuator::Hinge& hinge) { hinge.torque_offset = 10.0; });
  EXPECT_FALSE(find_equilibrium(folding, folding.all_coils(0.0), straight(folding)).has_value());
}

TEST(StableEquilibria, OfASimpleFingerAreOne) {
  const Model model = finger(Configuration::B).model;
  const auto found = stable_equilibria(model, model.all_coils(1.4));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].sum() / degree, 63.62, 0.005);  // the review's, tests/data/actuator_SOURCES.md
}

// A soft finger that stands on its base leans onto its stops or falls over: gravity makes two ends.
TEST(StableEquilibria, OfAFingerThatCanFallOverAreBothEndsInOrder) {
  actuator::Design design = actuator::paper_finger();
  design.surroundings.base_tilt = 2.9;
  const Model model =
      with_hinges(actuator::assemble_or_throw(design).model, [](actuator::Hinge& hinge) { hinge.stiffness *= 0.1; });
  const actuator::CoilCurrents currents = model.all_coils(0.0);
  const auto found = stable_equilibria(model, currents);
  ASSERT_EQ(found.size(), 2U);
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_GT(softest(model, found[i], currents), 0.0);
    EXPECT_LE(model.static_residual(found[i], currents).norm(), 1e-11 * torque_scale(model));
    if (i > 0) {
      EXPECT_GE(found[i].sum(), found[i - 1].sum());
    }
  }
}

}  // namespace
}  // namespace coilwright::simulation
