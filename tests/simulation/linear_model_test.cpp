#include "coilwright/simulation/linear_model.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <unsupported/Eigen/MatrixFunctions>

#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "coilwright/simulation/modes.hpp"
#include "coilwright/simulation/transient.hpp"
#include "error_text.hpp"
#include "simulation/reference.hpp"

namespace coilwright::simulation {
namespace {

using actuator::Configuration;

// Outputs of the linear model a time after a small step of the current, by the exponential of the matrix
// [A B; 0 0]: nothing is integrated.
Eigen::VectorXd outputs_after(const LinearModel& linear, double step, double time) {
  const Eigen::Index size = linear.a.rows();
  Eigen::MatrixXd both = Eigen::MatrixXd::Zero(size + 1, size + 1);
  both.topLeftCorner(size, size) = linear.a;
  both.topRightCorner(size, 1) = linear.b;
  const Eigen::MatrixXd moved = (both * time).exp();
  return linear.c * moved.topRightCorner(size, 1) * step + linear.d * step;
}

// The nonlinear model, stepped by a ten-thousandth of an ampere from its equilibrium, against the linear one.
void expect_small_step_alike(const Model& model, double current) {
  constexpr double step = 1e-4;
  const LinearModel linear = linearise(model, current);
  const ModelInput input = step_input(model, {.current = current + step, .duration = 0.3, .interval = 0.01});
  const State start{.angles = linear.angles,
                    .rates = straight(model),
                    .internal = model.settled(linear.angles, model.all_coils(current))};
  const std::vector<State> motion = simulate(model, input, start, {.relative = 1e-11});
  const double size = std::abs((*linear.dc_gain)(0, 0)) * step;
  for (std::size_t i = 1; i < motion.size(); ++i) {
    const Eigen::VectorXd expected = outputs_after(linear, step, input.times[i]);
    const mechanics::JointVector moved = motion[i].angles - linear.angles;
    // What is not linear grows with the step: 1e-4 of 1 A, and a curvature of that order over half of an ampere.
    EXPECT_NEAR(moved.sum(), expected[0], 1e-3 * size) << input.times[i];
    for (Eigen::Index j = 0; j < moved.size(); ++j) EXPECT_NEAR(moved[j], expected[1 + j], 1e-3 * size);
  }
}

TEST(LinearModel, MovesAsTheNonlinearOneDoesByASmallStep) {
  for (const double current : {0.4, 1.3}) expect_small_step_alike(finger(Configuration::B).model, current);
  expect_small_step_alike(finger(Configuration::A).model, 0.9);
}

double bending_at(const Model& model, double current, const JointVector& near) {
  return find_equilibrium(model, model.all_coils(current), near).value().sum();
}

TEST(LinearModel, HasTheSlopeOfTheEquilibriaAsItsGain) {
  const Model model = finger(Configuration::B).model;
  for (const double current : {0.0, 0.35, 1.05, 1.4}) {
    const LinearModel linear = linearise(model, current);
    constexpr double step = 1e-4;
    const double slope =
        (bending_at(model, current + step, linear.angles) - bending_at(model, current - step, linear.angles)) /
        (2.0 * step);
    // Equilibria are good to 1e-11 of the hinge's torque; the difference errs with the square of its step.
    EXPECT_NEAR((*linear.dc_gain)(0, 0), slope, 1e-6 * slope);
    EXPECT_NEAR((*linear.dc_gain)(1, 0) + (*linear.dc_gain)(2, 0), (*linear.dc_gain)(0, 0), 1e-14);
    EXPECT_TRUE(linear.stable());
    EXPECT_FALSE(linear.sticks);
  }
}

// What each coil does alone, against equilibria beside it; together they do what all of them do.
TEST(LinearModel, HasAColumnForEachCoil) {
  const Model model = finger(Configuration::B).model;
  actuator::CoilCurrents currents(2);
  currents << 1.3, 0.2;
  const LinearModel linear = linearise(model, currents);
  ASSERT_EQ(linear.b.cols(), 2);
  for (Eigen::Index coil = 0; coil < 2; ++coil) {
    constexpr double step = 1e-4;
    actuator::CoilCurrents more = currents, less = currents;
    more[coil] += step;
    less[coil] -= step;
    const JointVector slope =
        (find_equilibrium(model, more, linear.angles).value() - find_equilibrium(model, less, linear.angles).value()) /
        (2.0 * step);
    for (Eigen::Index j = 0; j < 2; ++j)
      EXPECT_NEAR((*linear.dc_gain)(1 + j, coil), slope[j], 1e-6 * slope.norm()) << coil;
  }
  const LinearModel together = linearise(model, 0.9);
  const LinearModel apart = linearise(model, actuator::CoilCurrents(model.all_coils(0.9)));
  EXPECT_EQ(apart.angles, together.angles);
  EXPECT_LT((apart.b.rowwise().sum() - together.b).norm(), 1e-12 * together.b.norm());
}

// One joint by hand: theta'' = (torque per ampere i - K theta - b theta') / J.
TEST(LinearModel, OfOneJointIsASpringAMassAndATorque) {
  const Model model = finger(Configuration::A).model;
  const LinearModel linear = linearise(model, 0.7);
  const double inertia = model.chain().mass_matrix(linear.angles)(0, 0);
  const actuator::HingePair& pair = model.magnetics().hinge_pairs().front();
  EXPECT_NEAR(linear.b(1, 0), pair.sense * pair.torque_per_ampere->value(linear.angles[0]) / inertia,
              1e-8 * linear.b(1, 0));
  EXPECT_EQ(linear.b(0, 0), 0.0);
  EXPECT_NEAR(linear.a(1, 0), -model.tangent_stiffness(linear.angles, model.all_coils(0.7))(0, 0) / inertia,
              -1e-12 * linear.a(1, 0));
  EXPECT_NEAR(linear.a(1, 1), -model.hinges()[0].damping / inertia, -1e-12 * linear.a(1, 1));
  EXPECT_EQ(linear.a(0, 1), 1.0);
}

TEST(LinearModel, SaysWhichFacesArePressed) {
  const Model model = finger(Configuration::B).model;
  EXPECT_TRUE(linearise(model, 1.0).pressed_joints.empty());
  EXPECT_EQ(linearise(model, -1.4).pressed_joints.size(), 2U);
}

// A lag of the current is a state of the linear model, which the current enters instead of the joints.
TEST(LinearModel, TakesTheStatesOfEffectsAlong) {
  actuator::Design design = actuator::paper_finger();
  design.effects = {{actuator::standard_effects().find("coil_lag"), {0.01}}};
  const Model model = actuator::assemble_or_throw(design).model;
  expect_small_step_alike(model, 1.0);
  EXPECT_GT(linearise(model, 1.0).effect_states, 0);
}

TEST(LinearModel, SaysThatFrictionSticks) {
  actuator::Design design = actuator::paper_finger();
  design.effects = {{actuator::standard_effects().find("dry_friction"), {0.2e-3}}};
  EXPECT_TRUE(linearise(actuator::assemble_or_throw(design).model, 1.0).sticks);
}

TEST(LinearModel, RefusesWhatItCannotDescribe) {
  const Model model = finger(Configuration::B).model;
  EXPECT_EQ(error_text([&] { (void)linearise(model, std::nan("")); }), "current must be finite; got nan A");
  EXPECT_THAT([&] { (void)linearise(model, 1e5); },
              testing::ThrowsMessage<std::runtime_error>(testing::MatchesRegex(
                  "rests with joint 1 at 13[0-9.]+ deg under 100000 A, and its torque is known up to 120 deg")));
  EXPECT_EQ(error_text([&] { (void)linearise(model, actuator::CoilCurrents(actuator::CoilCurrents::Ones(3))); }),
            "has 2 coils; a current for each is needed, got 3");
  actuator::Design design = actuator::paper_finger();
  design.effects = {{actuator::standard_effects().find("mount_compliance"), {20.0, 0.5}}};
  EXPECT_EQ(error_text([&] { (void)linearise(actuator::assemble_or_throw(design).model, 1.0); }),
            "has an effect with a body of its own, which a linear model leaves out");
}

}  // namespace
}  // namespace coilwright::simulation
