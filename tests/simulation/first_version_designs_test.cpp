// The best designs that version 0.1 found, with its hinge (a beam) and all of the damping proportional to it, under
// the laws that are tenable as well. Figures of an audit with statics and motions of its own.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>
#include <variant>

#include "actuator/paper_finger.hpp"
#include "coilwright/actuator/assemble.hpp"
#include "coilwright/actuator/hinges.hpp"
#include "coilwright/simulation/performance.hpp"

namespace coilwright::simulation {
namespace {

using actuator::DampingLaw;
using actuator::Design;

constexpr double degrees = 180.0 / std::numbers::pi;

// The prototype with segments as bodies, calibrated as version 0.1 did it.
Design first_version_finger() {
  Design design;
  design.choices.hinge = actuator::HingeLaw::beam;
  design.choices.damping = DampingLaw::proportional;
  design.choices.faces = actuator::ContactChoice::hard_parts;
  design.body.loss_time = 10.3e-3;
  design.body.constant_damping = 0.0;
  actuator::Measured measured = actuator::paper_measured();
  measured.coil_outer_radius = 9.5e-3;
  measured.coil_length = 12e-3;
  design.calibration = actuator::calibrate(design, measured);
  return design;
}

Design fastest_finger() {
  Design design = first_version_finger();
  design.coil.turns_radial = 14;
  design.coil.turns_axial = 10;
  design.coil.wire_gauge = 29;
  design.magnet.radius = 8.5e-3;
  design.magnet.length = 14e-3;
  design.body.gap = 0.6e-3;
  design.body.bottom_layer = 1.6e-3;
  return design;
}

Design least_ringing() {
  Design design = first_version_finger();
  design.coil.turns_radial = 20;
  design.coil.turns_axial = 15;
  design.coil.wire_gauge = 29;
  design.magnet.length = 7e-3;
  design.body.gap = 0.6e-3;
  design.body.bottom_layer = 3.9e-3;
  return design;
}

MotionSummary at_its_current(const Design& design) {
  return std::get<MotionSummary>(motion_of(actuator::assemble_or_throw(design).model, 1.2));
}

// The audit's constant part was the same in every body; here it goes with the volume.
Design with_damping_of_any_width(Design design, const actuator::DampingSplit& split) {
  design = actuator::with_damping(std::move(design), split);
  design.body.constant_damping *= std::pow(22e-3 / actuator::dimensions(design).width, 3.0);
  return design;
}

double speed(const Design& design, const actuator::DampingSplit& split) {
  return at_its_current(with_damping_of_any_width(design, split)).peak_bending_speed * degrees;
}

double damping_ratio(const Design& design, const actuator::DampingSplit& split) {
  return at_its_current(with_damping_of_any_width(design, split)).modes.front().damping_ratio;
}

TEST(FirstVersionDesigns, AreFastOrCalmByTheLawOfDampingThatIsTaken) {
  const Design fast = fastest_finger();
  EXPECT_NEAR(speed(fast, {.law = DampingLaw::proportional, .share = 1.0}), 3039.0, 0.5);
  EXPECT_NEAR(speed(fast, {.law = DampingLaw::proportional, .share = 0.0}), 1900.0, 3.0);
  // The audit's constant loss factor, 2912 and 0.122, is at the frequency about the steady angle under current, ours at
  // that of the finger hanging straight: 1.5 % more and 6 % less damping.
  EXPECT_NEAR(speed(fast, {.law = DampingLaw::loss_factor, .share = 1.0}), 2912.0, 10.0);

  const Design calm = least_ringing();
  EXPECT_NEAR(damping_ratio(calm, {.law = DampingLaw::proportional, .share = 1.0}), 0.232, 0.0005);
  EXPECT_NEAR(damping_ratio(calm, {.law = DampingLaw::loss_factor, .share = 0.0}), 0.057, 0.0005);
  EXPECT_NEAR(damping_ratio(calm, {.law = DampingLaw::loss_factor, .share = 1.0}), 0.122, 0.07 * 0.122);
}

TEST(FirstVersionDesigns, SwingFartherThanTheyRest) {
  const MotionSummary motion = at_its_current(fastest_finger());
  EXPECT_NEAR(motion.steady_angles.sum() * degrees, 90.0, 0.05);
  EXPECT_NEAR(motion.peak_angle * degrees, 127.5, 0.05);
  EXPECT_GT(motion.peak_joint_angle, 0.5 * motion.peak_angle);
  EXPECT_LT(motion.peak_joint_angle, motion.peak_angle);
}

// With the slit its hinge of 1.6 mm is 56 % stiffer: the audit has 79.2 degrees with the slit's 12.28 N mm/rad at 2.5
// mm.
TEST(FirstVersionDesigns, BendLessOnASlit) {
  const MotionSummary motion = at_its_current(actuator::with_hinge_law(fastest_finger(), actuator::HingeLaw::slit));
  EXPECT_NEAR(motion.steady_angles.sum() * degrees, 79.2, 0.8);
}

}  // namespace
}  // namespace coilwright::simulation
