#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "coilwright/actuator/demagnetisation.hpp"
#include "coilwright/actuator/design/current_limit.hpp"
#include "coilwright/actuator/heat.hpp"
#include "coilwright/simulation/equilibrium.hpp"
#include "coilwright/simulation/linear_model.hpp"
#include "coilwright/simulation/model_input.hpp"
#include "coilwright/simulation/performance.hpp"
#include "coilwright/thermal/steady_state.hpp"
#include "coilwright/winding/copper.hpp"
#include "simulation/heat_state.hpp"
#include "simulation/performance_at.hpp"
#include "simulation/reference.hpp"

// Coils that carry shares of the operating current, against the same coils with currents of their own.

namespace coilwright::simulation {
namespace {

using actuator::Design;
using mechanics::JointVector;

Design finger_with(double first, double second) {
  Design design = actuator::paper_finger();
  design.magnet.make_of(magnetics::find_magnet_grade("N52"));
  design.coil.current_shares = {first, second, 1.0, 1.0};
  return design;
}

// Half of twice the current is the current: in motion, heat, circuit and magnets alike.
TEST(CurrentShares, ScaleTheOperatingCurrent) {
  const OperatingPoint point{.current = 1.0, .period = 2.0, .supply = {.resistance = 0.3}};
  const Performance whole = performance_at(finger_with(1.0, 1.0), point);
  const Performance half =
      performance_at(finger_with(0.5, 0.5), {.current = 2.0, .period = 2.0, .supply = {.resistance = 0.3}});
  EXPECT_NEAR(half.cold.steady_angles.sum(), whole.cold.steady_angles.sum(), 1e-9);
  EXPECT_NEAR(half.cold.peak_bending_speed, whole.cold.peak_bending_speed, 1e-6);
  EXPECT_NEAR(half.cold.grasp_force, whole.cold.grasp_force, 1e-9);
  EXPECT_NEAR(half.axial_force, whole.axial_force, 1e-12);
  EXPECT_NEAR(performance_at(finger_with(-0.2, -0.5), {.current = 2.0}).axial_force, -whole.axial_force, 1e-12);
  EXPECT_EQ(operating_current_limit(finger_with(0.5, -0.2)), 2.0 * operating_current_limit(finger_with(1.0, 1.0)));
  const Heat& warm = whole.free.heat;
  const Heat& same = half.free.heat;
  EXPECT_NEAR(*same.coil_hot_spot, *warm.coil_hot_spot, 1e-6);
  EXPECT_NEAR(*same.magnet_temperature, *warm.magnet_temperature, 1e-6);
  EXPECT_NEAR(same.continuous_current, 2.0 * warm.continuous_current, 1e-9);
  EXPECT_NEAR(same.magnet_continuous_current, 2.0 * warm.magnet_continuous_current, 1e-9);
  EXPECT_NEAR(same.runaway_current, 2.0 * warm.runaway_current, 1e-9);
  EXPECT_NEAR(same.still_air_current, 2.0 * warm.still_air_current, 1e-9);
  EXPECT_NEAR(*same.ripple, *warm.ripple, 1e-9);
  EXPECT_NEAR(*same.electrics.power, *warm.electrics.power, 1e-6);
  EXPECT_NEAR(*same.electrics.voltage, *warm.electrics.voltage, 1e-6);
  EXPECT_NEAR(*same.electrics.supply_voltage, *warm.electrics.supply_voltage, 1e-6);
  EXPECT_NEAR(*same.electrics.supply_current, *warm.electrics.supply_current, 1e-9);
  ASSERT_TRUE(whole.demagnetisation && half.demagnetisation);
  EXPECT_NEAR(half.demagnetisation->margin, whole.demagnetisation->margin, 1e-9);
  EXPECT_NEAR(half.demagnetisation->margin_worst_point, whole.demagnetisation->margin_worst_point, 1e-9);
}

TEST(CurrentShares, MoveTheFingerAsCurrentsOfTheirOwnDo) {
  const actuator::Model plain = actuator::assemble_or_throw(finger_with(1.0, 1.0)).model;
  const actuator::Model shared = actuator::assemble_or_throw(finger_with(1.0, -0.4)).model;
  actuator::CoilCurrents own(2);
  own << 1.2, -0.48;
  EXPECT_NEAR((shared.all_coils(1.2) - own).cwiseAbs().maxCoeff(), 0.0, 1e-15);
  const auto expected = find_equilibrium(plain, own, JointVector::Zero(2));
  const auto found = find_equilibrium(shared, shared.all_coils(1.2), JointVector::Zero(2));
  ASSERT_TRUE(expected && found);
  EXPECT_EQ(*found, *expected);
  EXPECT_GT((*found)[0], 0.3);  // one joint opens
  EXPECT_LT((*found)[1], 0.1);  // the other closes
  // One input is the operating current; several are the coils' own.
  const LinearModel by_current = linearise(shared, 1.2);
  const LinearModel by_coils = linearise(plain, own);
  EXPECT_NEAR((by_current.b - (by_coils.b.col(0) - 0.4 * by_coils.b.col(1))).cwiseAbs().maxCoeff(), 0.0,
              1e-9 * by_coils.b.cwiseAbs().maxCoeff());
  EXPECT_EQ(linearise(shared, own).b, by_coils.b);
  const CommandedInput one{.drive = Drive::current, .times = {0.0}, .rows = {{1.2}}};
  EXPECT_EQ(model_input(shared, one).currents.front(), shared.all_coils(1.2));
  // A voltage is the same across all coils, whatever they are to carry.
  const CommandedInput volts{.drive = Drive::voltage, .times = {0.0}, .rows = {{4.2}}};
  EXPECT_EQ(model_input(shared, volts).currents.front(), model_input(plain, volts).currents.front());
}

// The heat network of a design whose coils share nothing, loaded coil by coil.
TEST(CurrentShares, HeatEachCoilByItsOwnCurrent) {
  const Design plain = finger_with(1.0, 1.0);
  const Design shared = finger_with(0.6, 1.0);
  const OperatingPoint point{.current = 1.1, .supply = {.resistance = 0.3}};
  const JointVector angles{{0.5, 0.3}};
  const Heat heat = heat_of(shared, actuator::assemble_or_throw(shared), point, angles);
  const actuator::Assembly assembly = actuator::assemble_or_throw(plain);
  const thermal::Network network = actuator::heat_network(plain, assembly, angles);
  const auto loaded = [&](double current) {
    thermal::NodeVector squares = thermal::NodeVector::Zero(network.size());
    squares[0] = 0.36 * current * current;  // coil, magnet, coil
    squares[2] = current * current;
    return thermal::steady_state(network, squares);
  };
  const thermal::SteadyState state = loaded(point.current);
  EXPECT_LT(state.temperatures[0], state.temperatures[2] - 20.0);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(heat.temperatures[i], state.temperatures[i], 1e-9) << i;
  // At its limits one part is where it may just be.
  EXPECT_NEAR(loaded(heat.continuous_current).hot_spots[2], 155.0, 1e-6);
  EXPECT_NEAR(loaded(heat.magnet_continuous_current).temperatures[1], plain.magnet.temperature_limit, 1e-6);
  EXPECT_EQ(loaded(1.0001 * heat.runaway_current).outcome, thermal::Outcome::runaway);
  EXPECT_EQ(loaded(0.9999 * heat.runaway_current).outcome, thermal::Outcome::settles);
  const auto resistance = [&](int node) {
    return assembly.coil.resistance * winding::copper_resistance_ratio(state.temperatures[node]);
  };
  const double first = 0.6 * 1.1;
  const double second = 1.1;
  EXPECT_NEAR(*heat.electrics.power, first * first * resistance(0) + second * second * resistance(2), 1e-9);
  EXPECT_NEAR(*heat.electrics.voltage, second * resistance(2), 1e-9);
  EXPECT_NEAR(*heat.electrics.supply_current, first + second, 1e-12);
  EXPECT_NEAR(*heat.electrics.supply_voltage, second * resistance(2) + 0.3 * (first + second), 1e-9);
}

TEST(CurrentShares, NeedDriversOfTheirOwnAndSomethingToCarry) {
  const Design shared = finger_with(1.0, 0.5);
  const auto none = performance_of(shared, actuator::assemble_or_throw(shared),
                                   {.current = 1.0, .supply = {.wiring = actuator::Wiring::series}});
  ASSERT_TRUE(std::holds_alternative<NoPerformance>(none));
  EXPECT_EQ(std::get<NoPerformance>(none).reason,
            "coils in series carry one current: shares of it need a driver for each coil (wiring parallel)");
  const auto faults = actuator::construction_faults(finger_with(0.0, 0.0));
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults.front().rule, "at least one coil must carry a share of the current; got 0 in all");
  const auto hardly = actuator::construction_faults(finger_with(1e-200, -1e-4));
  ASSERT_EQ(hardly.size(), 1U);
  EXPECT_EQ(hardly.front().rule, "the largest current share must be at least 0.001; got 0.0001");
  EXPECT_TRUE(actuator::construction_faults(finger_with(0.0, -1e-3)).empty());
  const auto beyond = actuator::construction_faults(finger_with(1.0, 1.5));
  ASSERT_EQ(beyond.size(), 1U);
  EXPECT_EQ(beyond.front().rule, "current_share_2 must be from -1 to 1; got 1.5");
}

}  // namespace
}  // namespace coilwright::simulation
