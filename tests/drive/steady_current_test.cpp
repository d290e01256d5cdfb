#include "coilwright/drive/steady_current.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>
#include <cmath>
#include <vector>

#include "drive/prototype_coils.hpp"
#include "error_text.hpp"

namespace coilwright::drive {
namespace {

HBridge bridge_with(Decay decay) {
  return {.supply_voltage = 24.0, .supply_resistance = 0.07, .dead_time = 3e-6, .decay = decay};
}

// The bridge again, from its switches and diodes in time instead of its phases, followed by Runge and Kutta.
class Oscilloscope {
 public:
  struct Reading {
    double mean, rms, peak, valley, source;
  };

  Oscilloscope(HBridge bridge, Pulses pulses, double step) : bridge_(bridge), pulses_(pulses), step_(step) {}

  Reading read(int settling, int measured) {
    for (int i = 0; i < settling; ++i) period();
    state_ = {state_[0], 0.0, 0.0, 0.0};
    peak_ = 0.0;
    valley_ = 1e9;
    for (int i = 0; i < measured; ++i) period();
    const double time = measured / pulses_.frequency;
    return {state_[1] / time, std::sqrt(state_[2] / time), peak_, valley_, state_[3] / time};
  }

 private:
  // current, charge, its square's integral, the source's work
  using State = std::array<double, 4>;

  // Steps end on every edge, so that no step sees a jump.
  void period() {
    const double period = 1.0 / pulses_.frequency, off = pulses_.duty * period, dead = bridge_.dead_time;
    double now = 0.0;
    for (const double edge : {dead, off, off + dead, period}) {
      const int steps = std::max(1, static_cast<int>(std::ceil((edge - now) / step_)));
      for (int i = 0; i < steps; ++i) step(now + (i + 0.5) * (edge - now) / steps, (edge - now) / steps);
      now = edge;
    }
  }

  void step(double middle, double length) {
    const double period = 1.0 / pulses_.frequency, dead = bridge_.dead_time;
    const bool command = middle < pulses_.duty * period;
    const bool edge = middle < dead || (!command && middle < pulses_.duty * period + dead);
    const bool bridge_on = command && !edge;
    // The limit: once tripped, both low switches are on for its off-time.
    const bool chopping = bridge_on && chop_left_ > 0.0;
    chop_left_ = bridge_on ? chop_left_ - length : 0.0;
    since_on_ = bridge_on && !chopping ? since_on_ + length : 0.0;
    double across = 0.0, resistance = bridge_.low_resistance * 2.0, source = 0.0;
    if (bridge_on && !chopping) {
      source = bridge_.supply_voltage;
      resistance = bridge_.high_resistance + bridge_.low_resistance + bridge_.supply_resistance;
    } else if (bridge_.decay == Decay::fast && !chopping) {
      source = -bridge_.supply_voltage;
      across = -2.0 * bridge_.diode_voltage;
      resistance = bridge_.supply_resistance;
    } else if (edge && !chopping) {
      across = -bridge_.diode_voltage;
      resistance = bridge_.low_resistance;
    }
    const auto slope = [&](const State& x, State& rate, double) {
      rate = {(source + across - (coils.resistance + resistance) * x[0]) / coils.inductance, x[0], x[0] * x[0],
              source * x[0]};
    };
    if (state_[0] > 0.0 || source > 0.0) stepper_.do_step(slope, state_, 0.0, length);
    state_[0] = std::max(0.0, state_[0]);
    peak_ = std::max(peak_, state_[0]);
    valley_ = std::min(valley_, state_[0]);
    if (bridge_.trip && bridge_on && !chopping && state_[0] >= *bridge_.trip && since_on_ >= bridge_.limit_blanking)
      chop_left_ = bridge_.limit_off_time;
  }

  HBridge bridge_;
  Pulses pulses_;
  double step_;
  State state_{};
  double chop_left_{}, since_on_{}, peak_{}, valley_{};
  boost::numeric::odeint::runge_kutta4<State> stepper_;
};

void expect_balance(const SteadyCurrent& current) {
  const DrivePowers& powers = current.powers;
  EXPECT_NEAR(powers.source / (powers.coils + powers.switches + powers.diodes + powers.supply + powers.stored), 1.0,
              1e-11);  // roundings of the exponentials' differences
  EXPECT_NEAR(powers.coils, coils.resistance * current.rms * current.rms, 1e-12);
}

TEST(SteadyCurrent, AgreesWithAnIntegrationOverManyPeriods) {
  struct Case {
    Decay decay;
    Pulses pulses;
    bool stops;
  };
  for (const Case& c : {Case{Decay::slow, {.frequency = 490.0, .duty = 0.37}, false},
                        Case{Decay::slow, {.frequency = 7300.0, .duty = 0.61}, false},
                        Case{Decay::fast, {.frequency = 490.0, .duty = 0.37}, true},
                        Case{Decay::fast, {.frequency = 7300.0, .duty = 0.83}, false}}) {
    const SteadyCurrent current = steady_current(coils, driver_of(bridge_with(c.decay)), c.pulses);
    const int settling = 2 + static_cast<int>(30.0 * coils.time_constant() * c.pulses.frequency);
    const Oscilloscope::Reading seen = Oscilloscope(bridge_with(c.decay), c.pulses, 2e-7).read(settling, 1);
    // Continuous: Runge and Kutta's fourth order. Where the current stops, the step in which it does, (0.2 us)^2 of a
    // slope of 10 A/ms against a charge of 1 mA s.
    const double tolerance = c.stops ? 1e-6 : 1e-9;
    EXPECT_NEAR(current.mean, seen.mean, tolerance);
    EXPECT_NEAR(current.rms, seen.rms, tolerance);
    EXPECT_NEAR(current.peak, seen.peak, 1e-9);
    EXPECT_NEAR(current.valley, seen.valley, 1e-9);
    EXPECT_NEAR(current.powers.source, seen.source, 24.0 * tolerance);
    EXPECT_EQ(current.is_discontinuous(), c.stops);
    EXPECT_EQ(current.valley == 0.0, c.stops);
    expect_balance(current);
  }
}

TEST(SteadyCurrent, AgreesWithAnIntegrationWhereTheLimitChops) {
  for (const Decay decay : {Decay::slow, Decay::fast}) {
    HBridge bridge = bridge_with(decay);
    bridge.trip = 1.53;
    const Pulses pulses{.frequency = 490.0, .duty = 0.72};
    const SteadyCurrent current = steady_current(coils, driver_of(bridge), pulses);
    const Oscilloscope::Reading seen = Oscilloscope(bridge, pulses, 2e-9).read(3, 1);
    EXPECT_TRUE(current.is_limited);
    EXPECT_TRUE(current.repeats);
    // A comparator that looks every 2 ns is 1 ns late in each of 35 cycles: the last one ends 0.35 mA off, which lasts
    // for a tenth of the period.
    EXPECT_NEAR(current.mean, seen.mean, 1e-4);
    EXPECT_NEAR(current.rms, seen.rms, 1e-4);
    EXPECT_NEAR(current.peak, 1.53, 1e-12);
    EXPECT_NEAR(seen.peak, 1.53, 1e-4);
    expect_balance(current);
  }
}

TEST(SteadyCurrent, OfALinearCircuitHasTheMeanOfItsVoltage) {
  const HBridge linear{.supply_voltage = 24.0, .high_resistance = 0.3, .low_resistance = 0.3, .dead_time = 0.0};
  for (const double frequency : {1.0, 490.0, 1e6})
    EXPECT_NEAR(steady_current(coils, driver_of(linear), {.frequency = frequency, .duty = 0.43}).mean,
                0.43 * 24.0 / 8.2, 1e-11);  // roundings over a period that is a ten-thousandth of L/R
}

TEST(SteadyCurrent, IsSmoothAtHighFrequencyAndSquareAtLow) {
  const HBridge linear{.supply_voltage = 24.0, .high_resistance = 0.3, .low_resistance = 0.3, .dead_time = 0.0};
  const double full = 24.0 / 8.2, duty = 0.43;
  const SteadyCurrent smooth = steady_current(coils, driver_of(linear), {.frequency = 1e6, .duty = duty});
  // Triangular: V D (1 - D) / (L f), up to (T / tau)^2 = 1e-5 of it.
  EXPECT_NEAR(smooth.ripple() / (24.0 * duty * (1.0 - duty) / (coils.inductance * 1e6)), 1.0, 1e-5);
  EXPECT_NEAR(smooth.rms / smooth.mean, 1.0, 1e-6);  // ripple^2 / 24 of the mean's square
  const SteadyCurrent square = steady_current(coils, driver_of(linear), {.frequency = 0.1, .duty = duty});
  // Rise and fall take tau = 0.28 ms of 10 s: 3e-5 of it.
  EXPECT_NEAR(square.rms, full * std::sqrt(duty), 1e-4);
  EXPECT_NEAR(square.ripple(), full, 1e-9);
}

TEST(SteadyCurrent, StopsAsATriangleInACoilWithoutResistance) {
  // The textbook's discontinuous conduction: up by V - 0 for D T, down by V + 2 diodes until zero.
  const Circuit pure{.resistance = 1e-6, .inductance = 2.33e-3};
  const HBridge bridge{.supply_voltage = 24.0,
                       .high_resistance = 0.0,
                       .low_resistance = 0.0,
                       .diode_voltage = 0.9,
                       .dead_time = 0.0,
                       .decay = Decay::fast};
  const double duty = 0.31, period = 1.0 / 490.0;
  const SteadyCurrent current = steady_current(pure, driver_of(bridge), {.frequency = 490.0, .duty = duty});
  const double peak = 24.0 * duty * period / 2.33e-3, falling = duty * 24.0 / 25.8;
  // R T / L = 1e-6 of each.
  EXPECT_NEAR(current.peak / peak, 1.0, 1e-6);
  EXPECT_NEAR(current.conduction, duty + falling, 1e-6);
  EXPECT_NEAR(current.mean / (0.5 * peak * (duty + falling)), 1.0, 1e-6);
  EXPECT_NEAR(current.rms / (peak * std::sqrt((duty + falling) / 3.0)), 1.0, 1e-6);
  EXPECT_NEAR(current.supply_mean / (0.5 * peak * (duty - falling)), 1.0, 1e-5);  // of a difference
}

TEST(SteadyCurrent, IsHeldBelowTheLimitWhileOnForGood) {
  HBridge bridge = bridge_with(Decay::slow);
  bridge.trip = 1.1;
  const SteadyCurrent current = steady_current(coils, driver_of(bridge), {.frequency = 490.0, .duty = 1.0});
  // Off-time of 25 us through the low switches, on until the limit.
  const double shorted = coils.resistance + 2.0 * 0.258, driven = coils.resistance + 0.565 + 0.07;
  const double valley = 1.1 * std::exp(-25e-6 * shorted / coils.inductance);
  const double on = coils.inductance / driven * std::log((24.0 - driven * valley) / (24.0 - driven * 1.1));
  EXPECT_NEAR(current.valley, valley, 1e-14);
  EXPECT_NEAR(current.peak, 1.1, 1e-14);
  // Charge of the driven part from its volt-seconds: V t = R Q + L (peak - valley).
  const double charge = (24.0 * on - coils.inductance * (1.1 - valley)) / driven;
  EXPECT_NEAR(current.powers.source, 24.0 * charge / (on + 25e-6), 1e-10);  // roundings of that difference
  expect_balance(current);
}

TEST(SteadyCurrent, PassesALimitThatTheBlankingTimeHides) {
  HBridge bridge = bridge_with(Decay::slow);
  bridge.trip = 0.02;
  const SteadyCurrent current = steady_current(coils, driver_of(bridge), {.frequency = 490.0, .duty = 1.0});
  EXPECT_GT(current.peak, 0.02);
  // Volt-seconds of 2 us on balance 25 us off: i R T = V t, to the ripple.
  const double charge = 24.0 * 2e-6 / ((coils.resistance + 0.516) * 25e-6 + (coils.resistance + 0.635) * 2e-6);
  EXPECT_NEAR(current.mean / charge, 1.0, 0.05);
  expect_balance(current);
}

TEST(SteadyCurrent, IsNothingForAPulseShorterThanTheDeadTime) {
  const SteadyCurrent none =
      steady_current(coils, driver_of(bridge_with(Decay::slow)), {.frequency = 490.0, .duty = 0.001});
  EXPECT_EQ(none.mean, 0.0);
  EXPECT_EQ(none.powers.source, 0.0);
  EXPECT_EQ(steady_current(coils, driver_of(bridge_with(Decay::slow)), {.frequency = 490.0, .duty = 0.0}).peak, 0.0);
}

TEST(SteadyCurrent, StaysTheSameWhenVoltageAndImpedanceScale) {
  const HBridge small = bridge_with(Decay::fast);
  HBridge large = small;
  const double k = 2.7;
  large.supply_voltage *= k;
  large.supply_resistance *= k;
  large.high_resistance *= k;
  large.low_resistance *= k;
  large.diode_voltage *= k;
  const Circuit stout{.resistance = k * coils.resistance, .inductance = k * coils.inductance};
  const Pulses pulses{.frequency = 911.0, .duty = 0.66};
  const SteadyCurrent a = steady_current(coils, driver_of(small), pulses);
  const SteadyCurrent b = steady_current(stout, driver_of(large), pulses);
  EXPECT_NEAR(a.mean / b.mean, 1.0, 1e-12);  // roundings
  EXPECT_NEAR(k * a.powers.source / b.powers.source, 1.0, 1e-12);
}

TEST(SteadyCurrent, BalancesItsBookWherePulsesBeatWithTheLimit) {
  // 20 kHz against an off-time of 25 us: periods need not repeat, and the answer says so.
  HBridge bridge = bridge_with(Decay::slow);
  for (const double trip : {0.6, 0.95, 1.31, 1.7}) {
    bridge.trip = trip;
    const SteadyCurrent current = steady_current(coils, driver_of(bridge), {.frequency = 17.3e3, .duty = 0.9});
    EXPECT_TRUE(current.is_limited);
    EXPECT_LE(current.mean, trip);
    expect_balance(current);
  }
}

TEST(SteadyCurrent, RejectsWhatIsNone) {
  const Driver driver = driver_of(bridge_with(Decay::slow));
  EXPECT_EQ(error_text([&] { (void)steady_current(coils, driver, {.frequency = 490.0, .duty = 1.2}); }),
            "duty: must be from 0 to 1; got 1.2");
  EXPECT_EQ(error_text([&] { (void)steady_current(coils, driver, {.frequency = 0.0, .duty = 0.2}); }),
            "frequency: must be finite and > 0; got 0");
  EXPECT_EQ(error_text([&] {
              (void)steady_current({.resistance = 3.0, .inductance = 0.0}, driver, {.frequency = 9.0, .duty = 0.2});
            }),
            "inductance: must be finite and > 0; got 0");
}

}  // namespace
}  // namespace coilwright::drive
