#include "coilwright/systems/driven_actuator.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "coilwright/actuator/heat.hpp"
#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "coilwright/thermal/steady_state.hpp"
#include "error_text.hpp"
#include "systems/paper_finger.hpp"

namespace coilwright::systems {
namespace {

using actuator::Assembly;
using drive::BankWiring;
using testing::Contains;
using testing::IsEmpty;

DrivenActuator driven(const DriveQuestion& question) {
  return drive_actuator(finger(), assembly(), question);
}

drive::HBridge ideal_bridge(double voltage) {
  return {.supply_voltage = voltage};
}

TEST(DrivenActuator, FitsFourCoilsInSeriesTo24VoltsAtThePapersCurrent) {
  // Two fingers: four coils of 3.76 ohm and a bridge of 0.565 ohm carry 24 / 15.6 A, full on.
  const DrivenActuator full =
      driven({.driver = ideal_bridge(24.0), .wiring = BankWiring::series, .actuators = 2, .duty = 1.0});
  EXPECT_NEAR(full.coil.mean, 24.0 / (4.0 * assembly().coil.resistance + 0.565), 1e-12);
  const DrivenActuator wanted =
      driven({.driver = ideal_bridge(24.0), .wiring = BankWiring::series, .actuators = 2, .mean = 1.4});
  EXPECT_NEAR(wanted.coil.mean, 1.4, 1e-9);  // the bisection's 1e-12 of a period
  EXPECT_GT(wanted.duty, 0.9);
  const DrivenActuator hot = driven({.driver = ideal_bridge(24.0),
                                     .wiring = BankWiring::series,
                                     .actuators = 2,
                                     .mean = 1.4,
                                     .coil_temperature = 60.0});
  EXPECT_THAT(hot.warnings, Contains(DriveWarning::out_of_reach));
}

TEST(DrivenActuator, HasMoreHeatThanItsMeanCurrentSuggests) {
  const DrivenActuator slow = driven({.driver = ideal_bridge(24.0), .duty = 0.3});
  EXPECT_GT(slow.coil.rms, slow.coil.mean);
  EXPECT_NEAR(slow.driver.powers.coils / slow.heat_by_mean, std::pow(slow.coil.rms / slow.coil.mean, 2), 1e-12);
  // Two like coils share evenly.
  EXPECT_NEAR(slow.coil.rms, 0.5 * slow.driver.rms, 1e-14);
  EXPECT_NEAR(slow.driver.powers.coils, 2.0 * assembly().coil.resistance * slow.coil.rms * slow.coil.rms, 1e-12);
}

TEST(DrivenActuator, FindsTheVoltageAtADuty) {
  const DrivenActuator found = driven({.driver = ideal_bridge(24.0), .duty = 0.8, .mean = 0.9});
  EXPECT_NEAR(found.coil.mean, 0.9, 1e-9);
  const DrivenActuator again = driven({.driver = ideal_bridge(found.supply_voltage), .duty = 0.8});
  EXPECT_EQ(again.coil.mean, found.coil.mean);
}

TEST(DrivenActuator, RunsOnACellAsLongAsItsChargeLasts) {
  // The paper's crawler: 4.2 V, 150 mAh, half of the time on, so slowly that L / R does not matter.
  const CellDrive cell{.circuit = {.emf = 4.2, .resistance = 0.1, .switch_resistance = 0.02, .diode_voltage = 0.4},
                       .capacity = 540.0};
  const DrivenActuator found = driven({.driver = cell, .frequency = 10.0, .duty = 0.5});
  const double on = 4.2 / (0.5 * assembly().coil.resistance + 0.12);
  // Each pulse loses about L / R = 0.3 ms of 50.
  EXPECT_NEAR(found.driver.supply_mean / (0.5 * on), 1.0, 0.01);
  ASSERT_TRUE(found.run_time.has_value());
  EXPECT_NEAR(*found.run_time, 540.0 / found.driver.supply_mean, 1e-9);
  EXPECT_THAT(found.warnings, Contains(DriveWarning::discontinuous));
}

TEST(DrivenActuator, DampsItsMotionAsTheEffectDoes) {
  // Without resistance in the driver each coil is its own loop: the effect back_emf with 1 / R.
  drive::HBridge ideal = ideal_bridge(24.0);
  ideal.high_resistance = ideal.low_resistance = 0.0;
  const DrivenActuator parallel = driven({.driver = ideal, .duty = 0.5});
  actuator::ModelSpec spec = assembly().model.nominal_spec();
  spec.effects.push_back(
      {.kind = actuator::standard_effects().find("back_emf"), .values = {1.0 / assembly().coil.resistance}});
  const actuator::Model with(spec);
  const mechanics::JointVector straight = mechanics::JointVector::Zero(with.joints());
  const auto none = with.all_coils(0.0);
  const double added = (with.damping(straight, none) - assembly().model.damping(straight, none)).sum();
  EXPECT_NEAR(parallel.motion.damping / added, 1.0, 1e-9);  // differences of torques
  // Like coils in series under a like rate of their joints: twice the voltage across twice the resistance.
  const DrivenActuator series = driven({.driver = ideal, .wiring = BankWiring::series, .duty = 0.5});
  EXPECT_NEAR(series.motion.damping / added, 1.0, 1e-9);
  EXPECT_NEAR(series.motion.emf_per_rate / parallel.motion.emf_per_rate, 2.0, 1e-9);
  EXPECT_LT(driven({.driver = ideal_bridge(24.0), .duty = 0.5}).motion.damping, parallel.motion.damping);
}

TEST(DrivenActuator, IsInBalanceWithItsOwnHeat) {
  // In series both coils have one current: the network's own steady state under it, where heat grows with temperature,
  // against temperatures that were found by heat alone.
  const thermal::Network network = heat_network(finger(), assembly());
  for (const double voltage : {9.0, 24.0}) {
    const DrivenActuator warm = driven(
        {.driver = ideal_bridge(voltage), .wiring = BankWiring::series, .duty = 0.5, .coil_temperature = std::nullopt});
    const thermal::SteadyState heat = steady_state(network, same_in_every_coil(network, warm.coil.rms * warm.coil.rms));
    ASSERT_EQ(heat.outcome, thermal::Outcome::settles);
    EXPECT_NEAR(heat.temperatures[0], warm.coil_temperatures[0], 1e-6);
    EXPECT_NEAR(heat.temperatures[2], warm.coil_temperatures[1], 1e-6);
    EXPECT_GT(*warm.steady_hot_spot, warm.coil_temperatures.maxCoeff());
    EXPECT_LT(warm.coil.rms,
              driven({.driver = ideal_bridge(voltage), .wiring = BankWiring::series, .duty = 0.5}).coil.rms);
  }
}

TEST(DrivenActuator, CoolsAVoltageThatARunningAwayCurrentWouldNot) {
  // Held at the current of the cold coils they would have no steady temperature; a voltage loses current as they warm.
  const DriveQuestion cold{.driver = ideal_bridge(10.5), .duty = 1.0};
  DriveQuestion own = cold;
  own.coil_temperature = std::nullopt;
  EXPECT_THAT(driven(cold).warnings, Contains(DriveWarning::runaway));
  const DrivenActuator warm = driven(own);
  EXPECT_GT(warm.coil_temperatures.maxCoeff(), finger().surroundings.coil_limit);
  EXPECT_THAT(warm.warnings, Contains(DriveWarning::above_continuous));
  EXPECT_THAT(warm.warnings, testing::Not(Contains(DriveWarning::runaway)));
}

TEST(DrivenActuator, WarnsOfWhatMatters) {
  EXPECT_THAT(driven({.driver = ideal_bridge(24.0), .frequency = 20e3, .mean = 0.5}).warnings, IsEmpty());
  EXPECT_THAT(driven({.driver = ideal_bridge(24.0), .frequency = 20e3, .mean = 1.3}).warnings,
              Contains(DriveWarning::above_continuous));
  EXPECT_THAT(driven({.driver = ideal_bridge(24.0), .frequency = 20e3, .mean = 1.5}).warnings,
              Contains(DriveWarning::above_ampacity));
  drive::HBridge limited = ideal_bridge(24.0);
  limited.trip = 2.0;
  EXPECT_THAT(driven({.driver = limited, .duty = 1.0}).warnings, Contains(DriveWarning::limited));
  EXPECT_THAT(driven({.driver = ideal_bridge(24.0), .duty = 0.2}).warnings, Contains(DriveWarning::ripple));
  drive::HBridge fast = ideal_bridge(24.0);
  fast.decay = drive::Decay::fast;
  EXPECT_THAT(driven({.driver = fast, .duty = 0.2}).warnings, Contains(DriveWarning::discontinuous));
  EXPECT_THAT(driven({.driver = ideal_bridge(24.0), .duty = 1e-5}).warnings, Contains(DriveWarning::dead_time));
  EXPECT_THAT(driven({.driver = ideal_bridge(24.0), .duty = 1.0}).warnings, Contains(DriveWarning::runaway));
}

TEST(DrivenActuator, RejectsEffectsOnTheCurrent) {
  actuator::Design lagging = finger();
  lagging.effects.push_back({.kind = actuator::standard_effects().find("driver_saturation"), .values = {0.5}});
  const Assembly built = actuator::assemble_or_throw(lagging);
  EXPECT_EQ(error_text([&] { (void)drive_actuator(lagging, built, {.driver = ideal_bridge(24.0), .duty = 0.5}); }),
            "effect driver_saturation: acts on the currents, which follow from the driver here");
}

TEST(DrivenActuator, RejectsWhatIsNone) {
  EXPECT_EQ(error_text([] { (void)driven({.driver = ideal_bridge(24.0)}); }),
            "duty or mean must be given; got neither");
  EXPECT_EQ(error_text([] { (void)driven({.driver = ideal_bridge(24.0), .actuators = 0, .duty = 0.5}); }),
            "actuators must be >= 1; got 0");
  EXPECT_EQ(error_text([] { (void)driven({.driver = ideal_bridge(24.0), .mean = -0.4}); }),
            "mean must be > 0; got -0.4 A");
  EXPECT_EQ(error_text([] { (void)driven({.driver = ideal_bridge(0.0), .duty = 0.5}); }),
            "supply_voltage: must be finite and > 0; got 0");
  EXPECT_EQ(
      error_text([] { (void)driven({.driver = CellDrive{.circuit = {.emf = 4.2}, .capacity = 0.0}, .duty = 0.5}); }),
      "capacity must be > 0; got 0 A s");
  EXPECT_EQ(
      error_text([] { (void)driven({.driver = ideal_bridge(200.0), .mean = 5.0, .coil_temperature = std::nullopt}); }),
      "coil temperature must be given: held for good, this drive heats the coils beyond 1085 degC, where copper "
      "melts");
}

}  // namespace
}  // namespace coilwright::systems
