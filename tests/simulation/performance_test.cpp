#include "coilwright/simulation/performance.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "simulation/electrics.hpp"
#include "simulation/heat_state.hpp"
#include "simulation/performance_at.hpp"
#include "simulation/reference.hpp"

namespace coilwright::simulation {
namespace {

using actuator::Design;
using ::testing::MatchesRegex;

TEST(Performance, AddsUpItsElectricalSide) {
  const Design design = actuator::paper_finger();
  const Performance p = performance_at(design, {.current = -0.8});
  EXPECT_NEAR(p.electrics_cold.voltage.value(), 0.8 * p.coil_resistance, 1e-14);
  EXPECT_NEAR(p.electrics_cold.power.value(), 2.0 * 0.8 * 0.8 * p.coil_resistance, 1e-14);
  EXPECT_NEAR(p.inductance, 1.155e-3, 5e-7);  // printed by the review of the winding room for the same section
  EXPECT_NEAR(p.mass, 68e-3, 0.5e-3);         // Table I
  EXPECT_EQ(p.current_limit, 1.4);            // the source paper's, through which the law goes
}

// At the current that its own pose allows, the hottest turn is at the limit of the enamel, and the mean below.
TEST(Performance, HeatsToItsLimitsAtItsContinuousCurrent) {
  const Design design = actuator::paper_finger();
  const actuator::Assembly a = actuator::assemble_or_throw(design);
  const mechanics::JointVector pose = mechanics::JointVector::Constant(2, 0.4);
  const auto heat = [&](double current) { return heat_of(design, a, {.current = current}, pose); };
  const Heat any = heat(1.0);
  EXPECT_NEAR(heat(any.continuous_current).coil_hot_spot.value(), 155.0, 1e-6);
  EXPECT_LT(heat(any.continuous_current).coil_temperature.value(), 150.0);
  EXPECT_NEAR(heat(any.magnet_continuous_current).magnet_temperature.value(), 80.0, 1e-6);
  EXPECT_FALSE(heat(1.01 * any.runaway_current).coil_temperature.has_value());
  EXPECT_TRUE(heat(0.99 * any.runaway_current).coil_temperature.has_value());
  EXPECT_LT(any.still_air_current, std::min(any.continuous_current, any.magnet_continuous_current));
}

TEST(Performance, SaysHowLongACurrentMayBeHeld) {
  const Design design = actuator::paper_finger();
  const actuator::Assembly a = actuator::assemble_or_throw(design);
  const mechanics::JointVector pose = mechanics::JointVector::Constant(2, 0.4);
  const auto heat = [&](const OperatingPoint& point) { return heat_of(design, a, point, pose); };
  const double allowed =
      std::min(heat({.current = 1.0}).continuous_current, heat({.current = 1.0}).magnet_continuous_current);
  EXPECT_FALSE(heat({.current = 0.99 * allowed}).time_to_limit.has_value());
  const Heat pulses = heat({.current = 1.5 * allowed, .duty = 0.3});
  EXPECT_GT(pulses.time_to_limit.value(), 10.0);
  EXPECT_LT(pulses.time_to_limit_warm.value(), pulses.time_to_limit.value());
  EXPECT_GT(pulses.time_to_limit_warm.value(), 0.0);
  EXPECT_EQ(heat({.current = -1.5 * allowed}).time_to_limit_warm.value(), 0.0);  // on all the time, beyond the limit
  EXPECT_LT(heat({.current = 2.0 * allowed}).time_to_limit.value(), pulses.time_to_limit.value());
}

// A coil alone takes up what it makes while it is on, and loses it while it is off.
TEST(Performance, BoundsTheRippleOfADutyCycle) {
  const Design design = actuator::paper_finger();
  const actuator::Assembly a = actuator::assemble_or_throw(design);
  const mechanics::JointVector pose = mechanics::JointVector::Constant(2, 0.4);
  const auto ripple = [&](double period) {
    return heat_of(design, a, {.current = 1.0, .duty = 0.5, .period = period}, pose).ripple.value();
  };
  EXPECT_NEAR(ripple(4.0), 2.0 * ripple(2.0), 1e-12);
  EXPECT_GT(ripple(4.0), 0.3);  // 5 W for 2 s into about 9 J/K, less what flows off meanwhile
  EXPECT_LT(ripple(4.0), 1.0);
  EXPECT_FALSE(heat_of(design, a, {.current = 1.0, .duty = 0.5}, pose).ripple.has_value());
}

// Two coils in series whose cold voltages add up to 12.4 V need 17.9 V at 133 degC: 1 + 0.00393 113 = 1.444.
TEST(Electrics, OfHotCoilsNeedMoreVoltage) {
  const Design design = actuator::paper_finger();
  const actuator::Assembly a = actuator::assemble_or_throw(design);
  const double current = 6.2 / a.coil.resistance;
  const thermal::NodeVector hot = thermal::NodeVector::Constant(2, 133.0);
  const OperatingPoint series{.current = current, .supply = {.wiring = actuator::Wiring::series}};
  const Electrics found = electrics_at(a, series, hot);
  EXPECT_NEAR(found.supply_voltage.value(), 17.9, 0.05);
  EXPECT_NEAR(found.voltage.value(), 8.95, 0.025);
  EXPECT_NEAR(found.supply_current.value(), current, 1e-12);
  const Electrics parallel = electrics_at(a, {.current = current}, hot);
  EXPECT_NEAR(parallel.supply_voltage.value(), 8.95, 0.025);
  EXPECT_NEAR(parallel.supply_current.value(), 2.0 * current, 1e-12);
  EXPECT_NEAR(parallel.power.value(), found.power.value(), 1e-12);
}

// What a battery drives at most is the current at which it needs its own voltage.
TEST(Electrics, OfABatteryLoseVoltageInside) {
  const Design design = actuator::paper_finger();
  const actuator::Assembly a = actuator::assemble_or_throw(design);
  const thermal::NodeVector hot = thermal::NodeVector::Constant(2, 90.0);
  for (const actuator::Wiring wiring : {actuator::Wiring::parallel, actuator::Wiring::series}) {
    OperatingPoint point{.current = 1.0, .supply = {.wiring = wiring, .resistance = 0.2, .voltage = 7.4}};
    const Electrics at_one = electrics_at(a, point, hot);
    EXPECT_NEAR(at_one.supply_voltage.value(),
                at_one.power.value() / at_one.supply_current.value() + 0.2 * at_one.supply_current.value(), 1e-12);
    point.current = at_one.driven_current.value();
    EXPECT_NEAR(electrics_at(a, point, hot).supply_voltage.value(), 7.4, 1e-12);
  }
}

TEST(Performance, CountsDutyForHeatOnly) {
  const Design design = actuator::paper_finger();
  const actuator::Assembly a = actuator::assemble_or_throw(design);
  const mechanics::JointVector pose = mechanics::JointVector::Constant(2, 0.4);  // the same of both
  EXPECT_NEAR(heat_of(design, a, {.current = 1.4, .duty = 0.5}, pose).coil_temperature.value(),
              heat_of(design, a, {.current = 1.4 * std::sqrt(0.5)}, pose).coil_temperature.value(), 1e-9);
  const Performance half = performance_at(design, {.current = 1.4, .duty = 0.5});
  EXPECT_EQ(half.cold.peak_bending_speed, performance_at(design, {.current = 1.4}).cold.peak_bending_speed);
}

TEST(Performance, SaysWhyThereIsNone) {
  const Design design = actuator::paper_finger();
  const actuator::Assembly a = actuator::assemble_or_throw(design);
  const auto reason = [&](const actuator::Assembly& assembly, double current) {
    return std::get<NoPerformance>(performance_of(design, assembly, {.current = current})).reason;
  };
  EXPECT_EQ(reason(a, std::numeric_limits<double>::infinity()), "the current is not finite");
  actuator::Assembly folding = a;
  folding.model = with_hinges(a.model, [](actuator::Hinge& hinge) { hinge.torque_offset = 10.0; });
  EXPECT_EQ(reason(folding, 1.0), "no stable rest pose: a joint folds without current");
  actuator::Assembly endless = a;
  endless.model = with_hinges(a.model, [](actuator::Hinge& hinge) { hinge.damping = 0.0; });
  EXPECT_EQ(reason(endless, 1.0), "the step from rest does not settle: a joint folds, or it rings beyond 60 s");
  EXPECT_THAT(reason(endless, 20.0),
              MatchesRegex("the step from rest does not settle: .*; beyond 1\\.9[0-9] A there is no steady temperature "
                           "either"));
}

TEST(Performance, RefusesADutyThatIsNone) {
  const Design design = actuator::paper_finger();
  const actuator::Assembly a = actuator::assemble_or_throw(design);
  EXPECT_EQ(coilwright::error_text([&] { (void)performance_of(design, a, {.current = 1.0, .duty = 1.5}); }),
            "duty: must be from 0 to 1; got 1.5");
}

TEST(Performance, IsTheSameBitsEveryTime) {
  const Design design = actuator::paper_finger();
  const Performance first = performance_at(design, {.current = 1.23});
  const Performance second = performance_at(design, {.current = 1.23});
  EXPECT_EQ(first.cold.peak_bending_speed, second.cold.peak_bending_speed);
  EXPECT_EQ(first.cold.settling_time, second.cold.settling_time);
  EXPECT_EQ(first.cold.grasp_force, second.cold.grasp_force);
  EXPECT_EQ(first.free.heat.coil_temperature, second.free.heat.coil_temperature);
}

bool all_finite(const Performance& p) {
  const MotionSummary& m = p.cold;
  bool finite = m.rest_angles.allFinite() && m.steady_angles.allFinite() && m.grasp_angles.allFinite() &&
                std::isfinite(m.peak_bending_speed + m.peak_speed_time + m.overshoot + m.rise_time.value_or(0.0) +
                              m.settling_time.value_or(0.0) + m.grasp_force + m.contact_force_no_current) &&
                std::isfinite(p.free.heat.coil_temperature.value_or(0.0) +
                              p.free.heat.magnet_temperature.value_or(0.0) + p.free.heat.continuous_current +
                              p.free.heat.magnet_continuous_current + p.free.heat.runaway_current) &&
                std::isfinite(p.axial_force + p.mass + p.inductance + p.electrics_cold.voltage.value() + p.cost);
  for (const Mode& mode : m.modes) finite = finite && std::isfinite(mode.natural_frequency + mode.damping_ratio);
  return finite && !m.modes.empty() && m.grasp_force >= 0.0 && m.overshoot >= 0.0;
}

// Two thousand designs (few of C and D: each takes as long as a thousand others), some far from anything sensible: each
// has numbers or a reason, none throws or hangs.
TEST(Performance, OfAnyDesignIsNumbersOrAReason) {
  std::mt19937 random(20240608);
  const auto spread = [&](double value, double decades) {
    return value * std::pow(10.0, std::uniform_real_distribution<double>(-decades, decades)(random));
  };
  int evaluated = 0;
  int without = 0;
  for (int i = 0; i < 2000; ++i) {
    Design d = actuator::paper_geometry();
    const double decades = i % 10 == 0 ? 0.8 : 0.2;
    d.layout = actuator::layout_of(static_cast<actuator::Configuration>(i % 200 < 198 ? i % 2 : 2 + i % 2));
    d.choices.faces = i % 3 == 0 ? actuator::ContactChoice::walls : actuator::ContactChoice::hard_parts;
    d.choices.masses = i % 2 == 0 ? actuator::SegmentMass::rigid_bodies : actuator::SegmentMass::on_axis_points;
    d.coil.inner_radius = spread(3e-3, decades);
    d.coil.turns_radial = 1 + static_cast<int>(random() % 25);
    d.coil.turns_axial = 1 + static_cast<int>(random() % 45);
    d.coil.wire_gauge = 20 + static_cast<int>(random() % 21);
    d.magnet.radius = spread(10e-3, decades);
    d.magnet.length = spread(6e-3, decades);
    d.body.gap = spread(0.9e-3, decades);
    d.body.bottom_layer = spread(2.5e-3, decades);
    d.body.front_length = spread(8.6e-3, decades);
    const auto assembled = actuator::assemble(d);
    const auto* assembly = std::get_if<actuator::Assembly>(&assembled);
    if (assembly == nullptr) continue;
    const double current = std::uniform_real_distribution<double>(-1.0, 3.0)(random);
    const auto result = performance_of(d, *assembly, {.current = current});
    ++evaluated;
    if (const auto* none = std::get_if<NoPerformance>(&result)) {
      ++without;
      ASSERT_FALSE(none->reason.empty());
    } else {
      ASSERT_TRUE(all_finite(std::get<Performance>(result))) << "design " << i;
    }
  }
  EXPECT_GT(evaluated, 1000);
  EXPECT_LT(without, evaluated / 4);
  RecordProperty("evaluated", evaluated);
  RecordProperty("without", without);
}

}  // namespace
}  // namespace coilwright::simulation
