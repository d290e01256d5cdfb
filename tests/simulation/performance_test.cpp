#include "coilwright/simulation/performance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "simulation/reference.hpp"

namespace coilwright::simulation {
namespace {

using actuator::Design;

Performance at(const Design& design, const OperatingPoint& point) {
  return std::get<Performance>(performance_of(design, actuator::assemble_or_throw(design), point));
}

TEST(Performance, AddsUpItsElectricalSide) {
  const Design design = actuator::paper_finger();
  const Performance p = at(design, {.current = -0.8});
  EXPECT_NEAR(p.voltage, 0.8 * p.coil_resistance, 1e-14);
  EXPECT_NEAR(p.power, 2.0 * 0.8 * 0.8 * p.coil_resistance, 1e-14);
  EXPECT_NEAR(p.inductance, 1.155e-3, 5e-7);  // printed by the review of the winding room for the same section
  EXPECT_NEAR(p.mass, 68e-3, 0.5e-3);         // Table I
  EXPECT_EQ(p.current_limit, 1.4);            // Table of chassis ampacity, AWG 28
}

TEST(Performance, HeatsToItsLimitsAtItsContinuousCurrent) {
  const Design design = actuator::paper_finger();
  const Performance p = at(design, {.current = 1.1});
  EXPECT_NEAR(p.free.heat.continuous_current, 1.1, 1e-9);
  EXPECT_NEAR(p.free.heat.coil_temperature.value(), 155.0, 1e-6);
  EXPECT_NEAR(at(design, {.current = p.free.heat.magnet_continuous_current}).free.heat.magnet_temperature.value(), 80.0, 1e-6);
  EXPECT_FALSE(at(design, {.current = 1.01 * p.free.heat.runaway_current}).free.heat.coil_temperature.has_value());
  EXPECT_TRUE(at(design, {.current = 0.99 * p.free.heat.runaway_current}).free.heat.coil_temperature.has_value());
}

TEST(Performance, CountsDutyForHeatOnly) {
  const Design design = actuator::paper_finger();
  const Performance half = at(design, {.current = 1.4, .duty = 0.5});
  const Performance steady = at(design, {.current = 1.4 * std::sqrt(0.5)});
  EXPECT_NEAR(half.free.heat.coil_temperature.value(), steady.free.heat.coil_temperature.value(), 1e-9);
  EXPECT_EQ(half.cold.peak_bending_speed, at(design, {.current = 1.4}).cold.peak_bending_speed);
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
}

TEST(Performance, RefusesADutyThatIsNone) {
  const Design design = actuator::paper_finger();
  const actuator::Assembly a = actuator::assemble_or_throw(design);
  EXPECT_EQ(coilwright::error_text([&] { (void)performance_of(design, a, {.current = 1.0, .duty = 1.5}); }),
            "duty: must be from 0 to 1; got 1.5");
}

TEST(Performance, IsTheSameBitsEveryTime) {
  const Design design = actuator::paper_finger();
  const Performance first = at(design, {.current = 1.23});
  const Performance second = at(design, {.current = 1.23});
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
                std::isfinite(p.free.heat.coil_temperature.value_or(0.0) + p.free.heat.magnet_temperature.value_or(0.0) +
                              p.free.heat.continuous_current + p.free.heat.magnet_continuous_current + p.free.heat.runaway_current) &&
                std::isfinite(p.axial_force + p.mass + p.inductance + p.voltage + p.power + p.cost);
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
