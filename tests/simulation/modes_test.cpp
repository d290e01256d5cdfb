#include "coilwright/simulation/modes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "coilwright/simulation/transient.hpp"
#include "simulation/reference.hpp"

namespace coilwright::simulation {
namespace {

using actuator::Configuration;

struct Ringing {
  double natural_frequency;
  double damping_ratio;
};

// Frequency and logarithmic decrement of a free motion of a hundred-thousandth of a radian about `angles`.
Ringing simulated(const Model& model, const JointVector& angles, double current, int first_extremum,
                  int last_extremum) {
  constexpr double interval = 1e-5;
  const ModelInput input = step_input(model, {.current = current, .duration = 1.2, .interval = interval});
  State start{.angles = angles, .rates = straight(model)};
  start.angles.array() += 1e-5;
  const std::vector<State> motion = simulate(model, input, start, {.relative = 1e-11});
  std::vector<double> times;
  std::vector<double> sizes;
  for (std::size_t i = 1; i < motion.size(); ++i) {
    const double before = motion[i - 1].rates.sum();
    const double after = motion[i].rates.sum();
    if (before * after >= 0.0) continue;
    const double share = before / (before - after);
    times.push_back(interval * (static_cast<double>(i - 1) + share));
    sizes.push_back(
        std::abs((1.0 - share) * motion[i - 1].angles.sum() + share * motion[i].angles.sum() - angles.sum()));
  }
  const double half_periods = last_extremum - first_extremum;
  const double damped = std::numbers::pi * half_periods / (times.at(last_extremum) - times.at(first_extremum));
  const double decay = std::log(sizes.at(first_extremum) / sizes.at(last_extremum)) /
                       (times.at(last_extremum) - times.at(first_extremum));
  const double natural = std::hypot(damped, decay);
  return {.natural_frequency = natural / (2.0 * std::numbers::pi), .damping_ratio = decay / natural};
}

TEST(Modes, OfOneJointAreItsFreeOscillation) {
  const Model model = finger(Configuration::A).model;
  const JointVector angles = find_equilibrium(model, model.all_coils(1.0), straight(model)).value();
  const std::vector<Mode> found = modes(model, angles, model.all_coils(1.0));
  ASSERT_EQ(found.size(), 1U);
  const Ringing free = simulated(model, angles, 1.0, 0, 4);
  // The spring is straight over 1e-5 rad to about 1e-5, and extrema are located to a hundredth of a sample.
  EXPECT_NEAR(found[0].natural_frequency, free.natural_frequency, 1e-4 * free.natural_frequency);
  EXPECT_NEAR(found[0].damping_ratio, free.damping_ratio, 1e-4);
}

TEST(Modes, OfTwoJointsShowInTheirFreeOscillation) {
  const Model model = finger(Configuration::B).model;
  const JointVector angles = find_equilibrium(model, model.all_coils(1.4), straight(model)).value();
  const std::vector<Mode> found = modes(model, angles, model.all_coils(1.4));
  ASSERT_EQ(found.size(), 2U);
  EXPECT_LT(found[0].natural_frequency, found[1].natural_frequency);
  const Ringing free = simulated(model, angles, 1.4, 3, 9);  // the fast mode has died down by the fourth extremum
  EXPECT_NEAR(found[0].natural_frequency, free.natural_frequency, 1e-3 * free.natural_frequency);
  EXPECT_NEAR(found[0].damping_ratio, free.damping_ratio, 1e-4);
}

// One joint by hand: f = sqrt(K / M) / 2 pi, zeta = b / 2 sqrt(K M).
TEST(Modes, OfOneJointAreThoseOfASpringAndAMass) {
  const Model model = finger(Configuration::A).model;
  const JointVector angles = find_equilibrium(model, model.all_coils(0.5), straight(model)).value();
  const double stiffness = model.tangent_stiffness(angles, model.all_coils(0.5))(0, 0);
  const double inertia = model.chain().mass_matrix(angles)(0, 0);
  const Mode mode = modes(model, angles, model.all_coils(0.5)).front();
  EXPECT_NEAR(mode.natural_frequency, std::sqrt(stiffness / inertia) / (2.0 * std::numbers::pi), 1e-11);
  EXPECT_NEAR(mode.damping_ratio, model.hinges()[0].damping / (2.0 * std::sqrt(stiffness * inertia)), 1e-12);
}

TEST(Modes, OfAnOverdampedJointAreTwoRatesWithoutOscillation) {
  const Model model =
      with_hinges(finger(Configuration::A).model, [](actuator::Hinge& hinge) { hinge.damping *= 20.0; });
  const JointVector angles = find_equilibrium(model, model.all_coils(0.5), straight(model)).value();
  const std::vector<Mode> found = modes(model, angles, model.all_coils(0.5));
  ASSERT_EQ(found.size(), 2U);
  EXPECT_DOUBLE_EQ(found[0].damping_ratio, 1.0);
  EXPECT_DOUBLE_EQ(found[1].damping_ratio, 1.0);
  // Their product is K / M.
  const double stiffness = model.tangent_stiffness(angles, model.all_coils(0.5))(0, 0);
  const double inertia = model.chain().mass_matrix(angles)(0, 0);
  const double product =
      found[0].natural_frequency * found[1].natural_frequency * 4.0 * std::numbers::pi * std::numbers::pi;
  EXPECT_NEAR(product, stiffness / inertia, 1e-9 * product);
}

}  // namespace
}  // namespace coilwright::simulation
