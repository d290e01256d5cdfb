#include "coilwright/actuator/calibrate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "actuator/paper_finger.hpp"
#include "coilwright/actuator/assemble.hpp"
#include "coilwright/actuator/heat.hpp"
#include "coilwright/thermal/steady_state.hpp"

namespace coilwright::actuator {
namespace {

constexpr double rounding_of_products = 1e-14;  // relative: a product and a quotient more than the derived value

Measured everything() {
  Measured measured = paper_measured();
  measured.coil_outer_radius = 9.8e-3;
  measured.coil_length = 12.7e-3;
  measured.coil_resistance = 4.0;
  return measured;
}

void expect_product(double value, double expected, const char* what) {
  EXPECT_NEAR(value, expected, rounding_of_products * std::abs(expected)) << what;
}

TEST(Calibrate, ReproducesEveryMeasuredValueAtItsGeometry) {
  Design design = paper_geometry();
  design.calibration = calibrate(design, everything());
  const Assembly a = assemble_or_throw(design);
  expect_product(a.dimensions.coil_outer_radius, 9.8e-3, "R_c");
  expect_product(a.dimensions.coil_length, 12.7e-3, "l_c");
  expect_product(a.dimensions.axis_offset, 11.5e-3, "h");
  for (const Hinge& hinge : a.model.hinges()) {
    expect_product(hinge.stiffness, 12.5e-3, "k");
    expect_product(hinge.damping, 1.29e-4, "b");
  }
  expect_product(a.segments[1].mass, 16.5e-3, "m_1");
  expect_product(a.segments[2].mass, 22.5e-3, "m_2");
  expect_product(a.segments[2].com_along, 9.1e-3, "l_2");
  expect_product(a.coil.resistance, 4.0, "R");
  const double current = thermal::continuous_current(heat_network(design, a), thermal::LimitedParts::coils).current;
  EXPECT_NEAR(current, 1.1, 1e-9);  // a root of a root: both brackets end below 1e-12 relative
}

TEST(Calibrate, LeavesWhatWasNotMeasuredAsDerived) {
  const Calibration factors = calibrate(paper_geometry(), {.joint_stiffness = 20e-3});
  EXPECT_NE(factors.joint_stiffness, 1.0);
  EXPECT_EQ(factors.joint_damping, 1.0);
  EXPECT_EQ(factors.axis_offset, 1.0);
  EXPECT_EQ(factors.radial_pitch, 1.0);
  EXPECT_EQ(factors.heat_transfer, 1.0);
}

// Where no part of b is to be constant, or b is below the silicone's own part, the silicone has all of it.
TEST(Calibrate, GivesTheSiliconeAllOfADampingThatLeavesNoRest) {
  Design design = paper_geometry();
  design.choices.damping = DampingLaw::proportional;
  design.body.loss_time = 10.3e-3;
  design.body.constant_damping = 0.0;
  design.calibration = calibrate(design, {.joint_stiffness = 12.5e-3, .joint_damping = 1.29e-4});
  expect_product(design.calibration.joint_damping / design.calibration.joint_stiffness, 1.29e-4 / 12.5e-3 / 10.3e-3,
                 "factor");
  design.body.constant_damping = 0.08e-3;
  design.calibration = calibrate(design, {.joint_stiffness = 12.5e-3, .joint_damping = 0.9e-4});
  EXPECT_EQ(design.calibration.constant_damping, 0.0);
  expect_product(assemble_or_throw(design).model.hinges()[0].damping, 0.9e-4, "b");
  design.body.loss_time = 0.0;
  design.body.constant_damping = 0.0;
  EXPECT_EQ(error_text([&] { (void)calibrate(design, {.joint_damping = 1.29e-4}); }),
            "measured joint damping: the body has neither a loss nor a constant damping to scale");
}

TEST(Calibrate, NotesTheJointThatWasMeasured) {
  EXPECT_FALSE(calibrate(paper_geometry(), {.axis_offset = 11.6e-3}).hinge.has_value());
  const HingeReference joint = calibrate(paper_geometry(), paper_measured()).hinge.value();
  expect_product(joint.width, 22e-3, "width");
  expect_product(joint.bottom_layer, 2.5e-3, "bottom layer");
  expect_product(joint.stiffness, 12.5e-3, "k");
  expect_product(joint.damping, 1.29e-4, "b");
}

TEST(Calibrate, IgnoresTheCalibrationItFinds) {
  const Design raw = paper_geometry();
  const Design calibrated = paper_finger();
  const Calibration again = calibrate(calibrated, paper_measured());
  EXPECT_EQ(again.joint_stiffness, calibrate(raw, paper_measured()).joint_stiffness);
  EXPECT_EQ(again.heat_transfer, calibrated.calibration.heat_transfer);
}

// The factors travel: a bottom layer 1.2 times as high is 1.2^2 times as stiff, measured factor included. Of the
// damping only the silicone's part follows.
TEST(Calibrate, KeepsItsFactorsWhenAVariableMoves) {
  Design design = paper_finger();
  const Assembly before = assemble_or_throw(design);
  design.body.bottom_layer *= 1.2;
  const Assembly after = assemble_or_throw(design);
  expect_product(after.model.hinges()[0].stiffness, 1.2 * 1.2 * before.model.hinges()[0].stiffness, "k");
  EXPECT_GT(after.model.hinges()[1].damping, before.model.hinges()[1].damping);
  EXPECT_LT(after.model.hinges()[1].damping, 1.2 * 1.2 * before.model.hinges()[1].damping);
  // h = R_m + 0.25 mm + h_b / 2, times a factor that is 1 to rounding here: 11.75 mm.
  expect_product(after.dimensions.axis_offset, 11.75e-3, "h");
}

// Sunk into each other's grooves, fifteen layers are fourteen pitches and one whole wire thick, and half a turn longer.
TEST(Calibrate, MeetsACoilWhoseLayersNest) {
  Design design = paper_geometry();
  design.calibration = calibrate(design, {.coil_outer_radius = 8.05e-3, .coil_length = 11.6e-3});
  const Dimensions size = dimensions(design);
  expect_product(size.coil_outer_radius, 8.05e-3, "R_c");
  expect_product(size.coil_length, 11.6e-3, "l_c");
  EXPECT_TRUE(winding_of(design).spec().packing.nested());
}

TEST(Calibrate, SaysWhatItCannotUse) {
  const auto text = [](const Measured& measured, Layout layout = layout_of(Configuration::B)) {
    Design design = paper_geometry();
    design.layout = std::move(layout);
    return error_text([&] { (void)calibrate(design, measured); });
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(text({.coil_outer_radius = 3e-3}), "measured coil outer radius must exceed the inner one (3 mm); got 3 mm");
  EXPECT_EQ(text({.coil_length = -12.0}), "measured coil length must be finite and > 0; got -12");
  EXPECT_EQ(text({.joint_stiffness = 0.0}), "measured joint stiffness must be finite and > 0; got 0");
  EXPECT_EQ(text({.joint_damping = nan}), "measured joint damping must be finite and > 0; got nan");
  EXPECT_EQ(text({.axis_offset = -1e-3}), "measured axis offset must be finite and > 0; got -0.001");
  EXPECT_EQ(text({.magnet_segment_mass = -0.5}), "measured magnet segment mass must be finite and > 0; got -0.5");
  EXPECT_EQ(text({.tip_segment_mass = 0.0}), "measured tip segment mass must be finite and > 0; got 0");
  EXPECT_EQ(text({.tip_com = 0.0}), "measured tip centre of mass must be finite and > 0; got 0");
  EXPECT_EQ(text({.coil_resistance = 0.0}), "measured coil resistance must be finite and > 0; got 0");
  EXPECT_EQ(text({.continuous_current = -1.1}), "measured continuous current must be finite and > 0; got -1.1");
  EXPECT_EQ(text({.magnet_segment_mass = 16e-3}, layout_of(Configuration::A)),
            "measured magnet segment mass: no magnet of this layout lies between two other parts");
  EXPECT_EQ(text({.tip_segment_mass = 16e-3}, layout_of(Configuration::A)),
            "measured tip segment mass: the last component of this layout is not a coil");
}

TEST(Calibrate, RefusesADesignThatCannotBeBuilt) {
  Design design = paper_geometry();
  design.coil.wire_gauge = 8;
  EXPECT_EQ(error_text([&] { (void)calibrate(design, {}); }), "wire gauge must be AWG 10 to 50; got 8");
}

// An axis measured inside the magnet is no axis of this body.
TEST(Calibrate, RefusesMeasurementsThatNoBodyHas) {
  EXPECT_EQ(error_text([] { (void)calibrate(paper_geometry(), {.axis_offset = 9.2e-3}); }),
            "hinge axis must lie below the parts, more than 10 mm from their centre; got 9.2 mm");
}

}  // namespace
}  // namespace coilwright::actuator
