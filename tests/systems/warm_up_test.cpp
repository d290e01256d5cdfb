#include "coilwright/systems/warm_up.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "coilwright/actuator/coil_bank.hpp"
#include "coilwright/actuator/heat.hpp"
#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "coilwright/thermal/transient.hpp"
#include "error_text.hpp"
#include "systems/paper_finger.hpp"

namespace coilwright::systems {
namespace {

DriveQuestion at_duty(double voltage, double duty) {
  return {.driver = drive::HBridge{.supply_voltage = voltage}, .duty = duty};
}

WarmUp warmed(const DriveQuestion& question, double duration, double interval) {
  return warm_up(finger(), assembly(), question, drive_actuator(finger(), assembly(), question),
                 {.duration = duration, .interval = interval});
}

TEST(WarmUp, BeginsInItsSurroundingsAndEndsWhereTheDriveIsHeldForGood) {
  DriveQuestion question = at_duty(9.0, 0.4);
  const WarmUp found = warmed(question, 4e4, 1e3);
  const double ambient = heat_network(finger(), assembly()).ambient();
  EXPECT_EQ(found.samples.front().coil_temperatures, Eigen::VectorXd::Constant(assembly().coils, ambient));
  EXPECT_EQ(found.samples.front().magnet_temperature, ambient);
  ASSERT_EQ(found.samples.size(), 41U);
  EXPECT_EQ(found.samples.back().time, 4e4);
  // The same by fixed-point rounds over steady states.
  question.coil_temperature.reset();
  const DrivenActuator held = drive_actuator(finger(), assembly(), question);
  EXPECT_NEAR((found.samples.back().coil_temperatures - held.coil_temperatures).cwiseAbs().maxCoeff(), 0.0, 1e-4);
  EXPECT_NEAR(found.samples.back().mean, held.coil.mean, 1e-6);
  EXPECT_NEAR(found.samples.back().rms, held.coil.rms, 1e-6);
}

TEST(WarmUp, HasTheCurrentOfADriveWhoseCoilsHaveThatTemperature) {
  const WarmUp found = warmed(at_duty(24.0, 0.2), 200.0, 50.0);
  for (const WarmUpSample& sample : found.samples) {
    DriveQuestion there = at_duty(24.0, 0.2);
    // Both coils of the straight finger are alike only by their heat: the one nearer to the tip has another neighbour.
    there.coil_temperature = sample.coil_temperatures.mean();
    const DrivenActuator driven = drive_actuator(finger(), assembly(), there);
    EXPECT_NEAR(sample.supply_mean / driven.driver.supply_mean, 1.0, 1e-4);
    EXPECT_NEAR(sample.heat / driven.driver.powers.coils, 1.0, 1e-4);
  }
}

// An independent integrator: short steps of thermal::Transient, exact under the mean square currents of the step, which
// are those of the temperatures in its middle, as the drive has them there.
TEST(WarmUp, IsThatOfShortStepsUnderHeldCurrents) {
  const DriveQuestion question = at_duty(24.0, 0.3);
  const DrivenActuator answer = drive_actuator(finger(), assembly(), question);
  constexpr double duration = 120.0;
  const WarmUp found = warmed(question, duration, duration);

  const thermal::Network network = heat_network(finger(), assembly());
  const std::vector<int> places = actuator::coil_places(finger().layout);
  const auto squares_at = [&](const thermal::NodeVector& temperatures) {
    Eigen::VectorXd of_coils(static_cast<Eigen::Index>(places.size()));
    for (std::size_t c = 0; c < places.size(); ++c) of_coils[static_cast<Eigen::Index>(c)] = temperatures[places[c]];
    const drive::ReducedBank bank = reduce(actuator::coil_bank(finger(), assembly(), question.wiring, of_coils));
    const double rms = steady_current(bank.circuit, answer.phases, {.frequency = question.frequency, .duty = 0.3}).rms;
    thermal::NodeVector out = thermal::NodeVector::Zero(network.size());
    for (std::size_t c = 0; c < places.size(); ++c)
      out[places[c]] = std::pow(bank.shares[static_cast<Eigen::Index>(c)] * rms, 2);
    return out;
  };
  thermal::NodeVector now = thermal::NodeVector::Constant(network.size(), network.ambient());
  constexpr int steps = 400;
  constexpr double step = duration / steps;
  for (int i = 0; i < steps; ++i) {
    const auto middle =
        thermal::Transient(network, {.mean_square_currents = squares_at(now), .initial = now}).temperatures(0.5 * step);
    now = thermal::Transient(network, {.mean_square_currents = squares_at(middle), .initial = now}).temperatures(step);
  }
  for (std::size_t c = 0; c < places.size(); ++c)
    EXPECT_NEAR(found.samples.back().coil_temperatures[static_cast<Eigen::Index>(c)], now[places[c]], 2e-3);
  EXPECT_GT(now[places[0]], network.ambient() + 30.0);
}

TEST(WarmUp, SaysWhichPartPassesItsLimitFirstAndWhen) {
  const DriveQuestion question{.driver = drive::HBridge{.supply_voltage = 24.0}, .mean = 2.0};
  const DrivenActuator answer = drive_actuator(finger(), assembly(), question);
  const WarmUp found = warm_up(finger(), assembly(), question, answer, {.duration = 600.0, .interval = 600.0});
  ASSERT_TRUE(found.limit);
  const WarmUp there =
      warm_up(finger(), assembly(), question, answer, {.duration = found.limit->time, .interval = found.limit->time});
  const WarmUpSample& last = there.samples.back();
  EXPECT_NEAR(found.limit->kind == thermal::NodeKind::coil ? last.coil_hot_spot : last.magnet_temperature,
              found.limit->limit, 0.01);
  EXPECT_GE(found.limit->number, 1);
}

TEST(WarmUp, EndsWhereCopperMelts) {
  const DriveQuestion question{.driver = drive::HBridge{.supply_voltage = 200.0}, .mean = 8.0};
  const WarmUp found = warmed(question, 3600.0, 1.0);
  ASSERT_TRUE(found.melting_time);
  EXPECT_LE(found.samples.back().time, *found.melting_time);
  EXPECT_GT(found.samples.back().time, *found.melting_time - 1.0);
  EXPECT_LT(found.samples.back().coil_temperatures.maxCoeff(), 1085.0 + 1e-3);
}

TEST(WarmUp, RefusesTimesThatMakeNoSense) {
  EXPECT_EQ(error_text([] { static_cast<void>(warmed(at_duty(9.0, 0.4), 0.0, 1.0)); }),
            "duration must be > 0; got 0 s");
  EXPECT_EQ(error_text([] { static_cast<void>(warmed(at_duty(9.0, 0.4), 1.0, 2.0)); }),
            "interval must be > 0 and at most the duration, 1 s; got 2 s");
}

}  // namespace
}  // namespace coilwright::systems
