#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "actuator/effects/rig.hpp"

namespace coilwright::actuator {
namespace {

constexpr double pi = std::numbers::pi;

double driven(std::string_view id, Numbers values, double current) {
  const WithEffect rig = with_effect(id, std::move(values), finger());
  CoilCurrents currents(2);
  currents << current, -0.3 * current;
  rig.term->drive({}, currents);
  return currents[0];
}

// Current of the first coil after `duration` of a command, from `y` on.
template <typename Command>
double current_after(const WithEffect& rig, Numbers& y, double duration, Command&& command) {
  const auto pass = [&](const Numbers& at, double* slopes, double time) {
    CoilCurrents currents = CoilCurrents::Constant(2, command(time));
    rig.term->drive({.states = at.data(), .slopes = slopes}, currents);
    return currents[0];
  };
  follow(y, duration, [&](const Numbers& at, Numbers& slope, double time) { (void)pass(at, slope.data(), time); });
  return pass(y, nullptr, duration);
}

TEST(DriverDeadband, IsOddAndContinuousAndLosesTheBand) {
  constexpr double band = 0.07;
  const auto out = [](double current) { return driven("driver_deadband", {band}, current); };
  for (const double current : {0.01, 0.0699, 0.0701, 0.35, 1.4}) EXPECT_EQ(out(-current), -out(current));
  EXPECT_EQ(out(0.5 * band), 0.0);
  EXPECT_EQ(out(band), 0.0);
  EXPECT_DOUBLE_EQ(out(band + 1e-6), 1e-6 + band - band);
  EXPECT_DOUBLE_EQ(out(1.4), 1.33);
}

TEST(DriverSaturation, CutsOffAtTheLimitOnly) {
  const auto out = [](double current) { return driven("driver_saturation", {1.12}, current); };
  EXPECT_EQ(out(0.93), 0.93);
  EXPECT_EQ(out(-1.11), -1.11);
  EXPECT_EQ(out(1.4), 1.12);
  EXPECT_EQ(out(-2.6), -1.12);
}

TEST(CurrentOffset, FlowsAtAnyCommand) {
  EXPECT_EQ(driven("current_offset", {0.013}, 0.0), 0.013);
  EXPECT_DOUBLE_EQ(driven("current_offset", {0.013}, -1.2), -1.187);
}

TEST(CoilLag, AnswersAStepByAnExponential) {
  constexpr double lag = 8e-3;
  const WithEffect rig = with_effect("coil_lag", {lag}, finger());
  for (const double time : {1e-3, 8e-3, 20e-3}) {
    Numbers y(2, 0.0);
    const double current = current_after(rig, y, time, [](double) { return 1.4; });
    EXPECT_NEAR(current, 1.4 * (1.0 - std::exp(-time / lag)), 1e-8);  // integrator: 1e-10 a step
  }
}

// Amplitude 1/sqrt(1 + (w T)^2) and phase -atan(w T), once the start is forgotten.
TEST(CoilLag, DelaysASineByItsPhase) {
  constexpr double lag = 8e-3;
  constexpr double omega = 2.0 * pi * 10.0;
  const WithEffect rig = with_effect("coil_lag", {lag}, finger());
  Numbers y(2, 0.0);
  const double time = 0.237;  // 30 time constants: 1e-13 of the start is left
  const double current = current_after(rig, y, time, [](double t) { return std::sin(omega * t); });
  const double expected = std::sin(omega * time - std::atan(omega * lag)) / std::hypot(1.0, omega * lag);
  EXPECT_NEAR(current, expected, 1e-8);
}

TEST(CoilLag, IsNoneWhereNoSampleCouldShowIt) {
  EXPECT_EQ(with_effect("coil_lag", {19e-6}, finger()).term, nullptr);
  EXPECT_NE(with_effect("coil_lag", {21e-6}, finger()).term, nullptr);
}

// R = R0 (1 + x) under the voltage u = R0 i0: power u i, and in the steady state x = a R0-free share of it.
TEST(CoilHeating, SettlesWhereHeatLeavesAsFastAsItComes) {
  constexpr double fade = 0.21;
  constexpr double command = 1.3;
  const WithEffect rig = with_effect("coil_heating", {fade, 30.0, 1.0}, finger());
  Numbers y(2, 0.0);
  const double current = current_after(rig, y, 1200.0, [](double) { return command; });
  const double rise = command / current - 1.0;
  EXPECT_NEAR(rise, fade * command * current, 1e-8);
  EXPECT_NEAR(y[0], rise, 1e-12);
  Numbers settled(2);
  const JointVector still = JointVector::Zero(2);
  rig.term->settle({.chain = rig.spec.chain, .angles = still, .rates = still}, CoilCurrents::Constant(2, command),
                   settled.data());
  EXPECT_NEAR(settled[1], rise, 1e-8);
}

// A loss of 1e-4 heats without changing the power: first order in i^2.
TEST(CoilHeating, WarmsAndCoolsWithItsTimeConstant) {
  constexpr double fade = 1e-4;
  constexpr double time_constant = 12.0;
  const WithEffect rig = with_effect("coil_heating", {fade, time_constant, 1.0}, finger());
  Numbers y(2, 0.0);
  (void)current_after(rig, y, 15.0, [](double) { return -1.1; });
  const double warm = fade * 1.21 * (1.0 - std::exp(-15.0 / time_constant));
  EXPECT_NEAR(y[0], warm, 2.0 * warm * fade);  // the power falls by a share of 1.2e-4
  (void)current_after(rig, y, 9.0, [](double) { return 0.0; });
  EXPECT_NEAR(y[0], warm * std::exp(-9.0 / time_constant), 2.0 * warm * fade);
}

TEST(CoilHeating, HeatsEachCoilByItsOwnCurrent) {
  const WithEffect rig = with_effect("coil_heating", {0.2, 30.0, 1.0}, finger());
  Numbers states(2, 0.0);
  Numbers slopes(2);
  CoilCurrents currents(2);
  currents << 1.0, 0.5;
  rig.term->drive({.states = states.data(), .slopes = slopes.data()}, currents);
  EXPECT_DOUBLE_EQ(slopes[0], 4.0 * slopes[1]);
}

TEST(CoilHeating, StartsColdWhereItIsSaidTo) {
  const WithEffect rig = with_effect("coil_heating", {0.2, 30.0, 0.0}, finger());
  const JointVector still = JointVector::Zero(2);
  Numbers settled(2, 1.0);
  rig.term->begin({.chain = rig.spec.chain, .angles = still, .rates = still}, CoilCurrents::Constant(2, 1.0),
                  settled.data());
  EXPECT_EQ(settled, Numbers(2, 0.0));
}

TEST(CoilHeating, IsSlowWhereAStepIsOverBefore) {
  EXPECT_TRUE(with_effect("coil_heating", {0.2, 30.0, 1.0}, finger()).term->slow());
  EXPECT_FALSE(with_effect("coil_heating", {0.2, 0.4, 1.0}, finger()).term->slow());
}

}  // namespace
}  // namespace coilwright::actuator
