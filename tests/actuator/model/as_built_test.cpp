#include "coilwright/actuator/model/as_built.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "coilwright/actuator/assemble.hpp"
#include "coilwright/actuator/parts/hinge_pair_parts.hpp"
#include "degree.hpp"
#include "error_text.hpp"

namespace coilwright::actuator {
namespace {

Design finger_of(magnetics::Fidelity fidelity) {
  Design design;
  design.choices.torque = fidelity;
  return design;
}

const TorqueCurveError error{.lower = 5.0 * degree, .upper = 65.0 * degree, .coefficients = {0.01, 0.03, -0.02, 0.015}};

TEST(TorqueCurveError, IsASumOfLegendresPolynomials) {
  // std::legendre is another implementation.
  for (const double x : {-1.0, -0.3, 0.0, 0.45, 1.0}) {
    double sum = 1.0;
    for (unsigned n = 0; n < 4; ++n) sum += error.coefficients[n] * std::legendre(n, x);
    EXPECT_NEAR(error.factor((35.0 + 30.0 * x) * degree), sum, 1e-14) << x;
  }
}

TEST(TorqueCurveError, GoesOnSmoothlyAndBoundedBeyondItsRange) {
  // Value, slope and curvature meet at the ends; the step of 1e-4 rad leaves a third derivative of order 10.
  const double h = 1e-4;
  for (const double end : {error.lower, error.upper}) {
    const auto slope = [&](double at) { return (error.factor(at + h) - error.factor(at - h)) / (2.0 * h); };
    const auto bend = [&](double at) {
      return (error.factor(at + h) - 2.0 * error.factor(at) + error.factor(at - h)) / (h * h);
    };
    EXPECT_NEAR(slope(end - 2.0 * h), slope(end + 2.0 * h), 1e-3);
    EXPECT_NEAR(bend(end - 2.0 * h), bend(end + 2.0 * h), 0.05);
  }
  for (const double far : {-90.0, 120.0, 400.0}) {
    EXPECT_LT(std::abs(error.factor(far * degree) - 1.0), 0.12) << far;
    EXPECT_NEAR(error.factor(far * degree), error.factor(far * 1.5 * degree), 1e-6) << far;
  }
}

TEST(TorqueCurveError, MultipliesTheCurveToAMillionth) {
  for (const auto fidelity : {magnetics::Fidelity::line_of_centres, magnetics::Fidelity::exact}) {
    const Assembly drawn = assemble_or_throw(finger_of(fidelity));
    const auto& curve = drawn.model.magnetics().hinge_pairs()[0].torque_per_ampere;
    const auto product = with_error(curve, error);
    for (double angle = curve->lower(); angle <= curve->upper(); angle += 0.003)
      EXPECT_NEAR(product->value(angle), curve->value(angle) * error.factor(angle), 1e-6 * curve->scale()) << angle;
    EXPECT_EQ(with_error(curve, {.lower = 0.0, .upper = 1.0}), curve);  // no error, the very curve
  }
  EXPECT_EQ(error_text([] { (void)with_error(nullptr, {.lower = 0.5, .upper = 0.5}); }),
            "range of a torque curve's error must end above its beginning (0.5); got 0.5");
}

TEST(AsBuilt, ChangesJointsInTurn) {
  Design design = finger_of(magnetics::Fidelity::line_of_centres);
  const Assembly drawn = assemble_or_throw(design);
  design.as_built = {.force_curve = error,
                     .joint_stiffness_ratio = 0.08,
                     .joint_damping_ratio = -0.2,
                     .face_closing_shift = -1.5 * degree};
  const Assembly built = assemble_or_throw(design);
  const std::vector<Hinge>& before = drawn.model.hinges();
  const std::vector<Hinge>& after = built.model.hinges();
  EXPECT_DOUBLE_EQ(after[0].stiffness, 0.96 * before[0].stiffness);
  EXPECT_DOUBLE_EQ(after[1].stiffness, 1.04 * before[1].stiffness);
  EXPECT_DOUBLE_EQ(after[0].damping, 1.1 * before[0].damping);
  EXPECT_DOUBLE_EQ(after[1].damping, 0.9 * before[1].damping);
  EXPECT_DOUBLE_EQ(after[1].contact.closing_angle, before[1].contact.closing_angle - 1.5 * degree);
  const auto torque = [](const Assembly& assembly) {
    return assembly.model.magnetics().hinge_pairs()[1].torque_per_ampere->value(20.0 * degree);
  };
  EXPECT_NEAR(torque(built), torque(drawn) * error.factor(20.0 * degree), 2e-6 * torque(drawn));
}

// The exact force of a pair has the error of the approximated one: off_axis_force takes its curve from the parts.
TEST(AsBuilt, KeepsItsErrorWhereTheForceBecomesExact) {
  Design design = finger_of(magnetics::Fidelity::line_of_centres);
  design.as_built.force_curve = error;
  const Assembly built = assemble_or_throw(design);
  const HingePair& pair = built.model.magnetics().hinge_pairs()[0];
  const Assembly exact = assemble_or_throw(finger_of(magnetics::Fidelity::exact));
  const HingePair& exact_pair = exact.model.magnetics().hinge_pairs()[0];
  EXPECT_NEAR(pair.parts->exact_torque()->value(0.4), exact_pair.torque_per_ampere->value(0.4) * error.factor(0.4),
              2e-6 * exact_pair.torque_per_ampere->scale());
}

// In turn, as the ratio has them, and all alike, as the design has them, are two special cases.
TEST(AsBuilt, ChangesEachJointByItself) {
  Design design = finger_of(magnetics::Fidelity::line_of_centres);
  design.as_built.joint_stiffness_ratio = 0.08;
  const Assembly in_turn = assemble_or_throw(design);
  design.as_built = {.joint_stiffness_factors = {0.96, 1.04}};
  const Assembly one_by_one = assemble_or_throw(design);
  for (std::size_t j = 0; j < 2; ++j) {
    EXPECT_DOUBLE_EQ(one_by_one.model.hinges()[j].stiffness, in_turn.model.hinges()[j].stiffness);
    EXPECT_EQ(one_by_one.model.hinges()[j].damping, in_turn.model.hinges()[j].damping);
  }
  design.as_built = {.joint_stiffness_factors = {0.9, 0.9}};
  const Assembly alike = assemble_or_throw(design);
  design.as_built = {};
  const Assembly drawn = assemble_or_throw(design);
  design.calibration.joint_stiffness *= 0.9;
  const Assembly softer = assemble_or_throw(design);
  for (std::size_t j = 0; j < 2; ++j) {
    EXPECT_DOUBLE_EQ(alike.model.hinges()[j].stiffness, softer.model.hinges()[j].stiffness);
    EXPECT_EQ(alike.model.hinges()[j].damping, drawn.model.hinges()[j].damping);
  }
}

// Both magnets alike make the torques of magnets with that remanence; one alone changes the joints beside it, and what
// it does further away.
TEST(AsBuilt, ChangesEachMagnetByItself) {
  Design design = finger_of(magnetics::Fidelity::line_of_centres);
  design.layout = layout_of(Configuration::C);
  const Assembly drawn = assemble_or_throw(design);
  const mechanics::JointVector angles{{0.3, 0.1, 0.45, 0.2}};
  const auto torques = [&](const Assembly& assembly) {
    return assembly.model.magnetic_torques(angles, assembly.model.all_coils(0.9));
  };
  Design weaker = design;
  weaker.magnet.remanence *= 0.9;
  const Assembly rebuilt = assemble_or_throw(weaker);
  design.as_built.remanence_factors = {0.9, 0.9};
  const Assembly alike = assemble_or_throw(design);
  EXPECT_LT((torques(alike) - torques(rebuilt)).norm(), 1e-12 * torques(rebuilt).norm());
  EXPECT_NEAR(alike.rest_force_per_ampere, rebuilt.rest_force_per_ampere,
              1e-12 * std::abs(rebuilt.rest_force_per_ampere));
  design.as_built.remanence_factors = {0.9, 1.0};
  const Assembly first = assemble_or_throw(design);
  for (const HingePair& pair : first.model.magnetics().hinge_pairs())
    EXPECT_EQ(pair.sense, pair.joint < 2 ? 0.9 : 1.0) << pair.joint;
  design.as_built.remanence_factors = {1.0, 0.9};
  const Assembly second = assemble_or_throw(design);
  EXPECT_EQ(second.rest_force_per_ampere, drawn.rest_force_per_ampere);
  // Torques are linear in each magnet by itself.
  const mechanics::JointVector both = torques(first) + torques(second) - torques(drawn);
  const mechanics::JointVector pull = drawn.model.magnetic_torques(angles, drawn.model.all_coils(0.0));
  EXPECT_LT((both + 0.01 * pull - torques(alike)).norm(), 1e-12 * torques(alike).norm());
}

TEST(AsBuilt, RefusesFactorsOfOtherParts) {
  Design design = finger_of(magnetics::Fidelity::line_of_centres);
  design.as_built.joint_stiffness_factors = {1.0};
  EXPECT_NE(
      error_text([&] { (void)assemble_or_throw(design); }).find("joint_stiffness_factors: one each, 2 here; got 1"),
      std::string::npos);
  design.as_built = {.remanence_factors = {1.0, 1.0}};
  EXPECT_NE(error_text([&] { (void)assemble_or_throw(design); }).find("remanence_factors: one each, 1 here; got 2"),
            std::string::npos);
}

TEST(AsBuilt, RefusesJointsWithLessThanNothing) {
  Design design = finger_of(magnetics::Fidelity::line_of_centres);
  design.as_built.joint_stiffness_ratio = 2.1;
  EXPECT_NE(
      error_text([&] { (void)assemble_or_throw(design); }).find("joint_stiffness_ratio must be from -2 to 2; got 2.1"),
      std::string::npos);
}

}  // namespace
}  // namespace coilwright::actuator
