#include "coilwright/measurement/design_posterior.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "coilwright/actuator/model/effect_catalogue.hpp"

namespace coilwright::measurement {
namespace {

// Two calibrated numbers and one of an effect; of the second nothing is known.
Diagnosis diagnosis_of_three() {
  Diagnosis out;
  out.calibration = {{.key = "joint_stiffness_Nmm_rad", .value = 2.0}, {.key = "joint_damping_Nmms_rad", .value = 3.0}};
  const actuator::EffectKind* drag = actuator::standard_effects().find("quadratic_drag");
  out.effects = {{.kind = drag, .parameters = {{.key = "drag_Nmms2_rad2", .value = 1e-5}}}};
  out.covariance = Eigen::MatrixXd::Zero(3, 3);
  out.covariance(0, 0) = 0.04;
  out.covariance(2, 2) = 1e-14;
  out.covariance(0, 2) = out.covariance(2, 0) = -1e-8;
  return out;
}

// A design in which stiffness and its damping follow from the first number, in proportion and by its square.
actuator::Design design_of(std::span<const double> calibration, const std::vector<actuator::Effect>& effects) {
  actuator::Design design;
  design.calibration.joint_stiffness = 0.5 * calibration[0];
  design.calibration.joint_damping = calibration[0] * calibration[0];
  design.calibration.constant_damping = calibration[1];
  design.effects = effects;
  return design;
}

// By the derivatives 0.5 and 4 of that design: deviations 0.1 and 0.8, wholly correlated; the drag's own is 1e-7 and
// its correlation -1e-8 / (0.2 * 1e-7) with both.
TEST(DesignPosterior, IsThatOfTheFitInNumbersOfTheDesign) {
  const DesignPosterior posterior = design_posterior(diagnosis_of_three(), design_of);
  ASSERT_EQ(posterior.numbers.size(), 3u);
  EXPECT_EQ(posterior.numbers[0].name, "joint_stiffness_factor");
  EXPECT_NEAR(posterior.numbers[0].value, 1.0, 1e-15);
  EXPECT_NEAR(posterior.numbers[0].sd, 0.1, 1e-9);
  EXPECT_EQ(posterior.numbers[1].name, "joint_damping_factor");
  EXPECT_NEAR(posterior.numbers[1].sd, 0.8, 1e-9);
  EXPECT_EQ(posterior.numbers[2].name, "quadratic_drag.drag_Nmms2_rad2");
  EXPECT_NEAR(posterior.numbers[2].value, 0.01, 1e-12);
  EXPECT_NEAR(posterior.numbers[2].sd, 1e-4, 1e-12);
  EXPECT_NEAR(posterior.correlation(0, 1), 1.0, 1e-9);
  EXPECT_NEAR(posterior.correlation(0, 2), -0.5, 1e-9);
  EXPECT_NEAR(posterior.correlation(1, 2), -0.5, 1e-9);
}

// Rounding took one of them to 1.0000000000000002, which readers refuse.
TEST(DesignPosterior, HasNoCorrelationBeyondOne) {
  for (double variance = 0.01; variance < 2.0; variance *= 1.01) {
    Diagnosis found = diagnosis_of_three();
    found.covariance(0, 0) = variance;
    const DesignPosterior posterior = design_posterior(found, design_of);
    EXPECT_LE(posterior.correlation.cwiseAbs().maxCoeff(), 1.0) << variance;
  }
}

// As of a diagnosis that was interrupted.
TEST(DesignPosterior, IsEmptyWhereNothingIsKnown) {
  Diagnosis nothing = diagnosis_of_three();
  nothing.covariance.resize(0, 0);
  EXPECT_TRUE(design_posterior(nothing, design_of).numbers.empty());
}

}  // namespace
}  // namespace coilwright::measurement
