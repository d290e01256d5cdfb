// Time stepping with friction against closed solutions, and against an integration with another law of contact.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "coilwright/mechanics/moreau_step.hpp"

namespace coilwright::mechanics {
namespace {

constexpr double gravity = 9.81;
constexpr double mass = 0.23;
constexpr double pi = 3.14159265358979323846;

CoordinateVector vector(double x, double y) {
  CoordinateVector out(2);
  out << x, y;
  return out;
}

struct Block {
  CoordinateVector position = vector(0.0, 0.0);
  CoordinateVector velocity = vector(0.0, 0.0);
  double friction_work = 0.0;  // taken out, J
  double impact_work = 0.0;    // taken out, J
};

// A point on a plane that is tilted by `slope`, rad, under further acceleration `drive` along it.
void advance(Block& block, double step, const DirectionalFriction& friction, double slope = 0.0, double drive = 0.0) {
  const MoreauStep next =
      moreau_step(block.position, block.velocity, step, [&](const CoordinateVector& at, const CoordinateVector&) {
        MiddleOfStep middle{mass * CoordinateMatrix::Identity(2, 2),
                            mass * vector(-gravity * std::sin(slope) + drive, -gravity * std::cos(slope)),
                            {}};
        if (at[1] <= closed_gap) middle.contacts.push_back({vector(0.0, 1.0), vector(1.0, 0.0), friction});
        return middle;
      });
  block.position = next.position;
  block.velocity = next.velocity;
  for (const ContactImpulse& impulse : next.impulses) {
    block.friction_work -= impulse.tangential * next.middle_velocity[0];
    block.impact_work -= impulse.normal * next.middle_velocity[1];
  }
}

TEST(Friction, StopsASlidingBlockWhereItsEnergyIsUsedUp) {
  const double speed = 0.83, mu = 0.31;
  const double distance = speed * speed / (2.0 * mu * gravity);
  std::vector<double> errors;
  for (const double step : {8e-4, 4e-4, 2e-4, 1e-4}) {
    Block block{.velocity = vector(speed, 0.0)};
    for (int k = 0; k < std::lround(0.5 / step); ++k) advance(block, step, {mu, 0.9});
    EXPECT_LT(std::abs(block.velocity[0]), 1e-16);
    // Work and energy agree to rounding at any step: impulses work at the mean of both velocities.
    EXPECT_NEAR(block.friction_work, 0.5 * mass * speed * speed, 1e-14);
    errors.push_back(std::abs(block.position[0] - distance));
    // Only the last step errs, in which it stops from v < mu g step: v step / 2 - v^2 / (2 mu g) <= mu g step^2 / 8.
    EXPECT_LE(errors.back(), 0.125 * mu * gravity * step * step + 1e-13);  // and rounding of 5000 steps
  }
  EXPECT_LT(errors.back(), 0.1 * errors.front() + 1e-12);
}

TEST(Friction, ResistsEachDirectionByItsOwnCoefficient) {
  for (const double sign : {1.0, -1.0}) {
    const DirectionalFriction friction{.along = 0.2, .against = 0.5};
    const double mu = sign > 0.0 ? friction.along : friction.against;
    Block block{.velocity = vector(sign * 0.7, 0.0)};
    const double step = 1e-4;
    for (int k = 0; k < 5000; ++k) advance(block, step, friction);
    EXPECT_NEAR(block.position[0], sign * 0.49 / (2.0 * mu * gravity), 0.125 * mu * gravity * step * step + 1e-13);
  }
}

TEST(Friction, HoldsOnASlopeBelowItsAngleAndLetsSlideAboveIt) {
  const double mu = 0.4;
  const DirectionalFriction friction{.along = 0.9, .against = mu};  // it slides down: along -x
  Block still;
  for (int k = 0; k < 1000; ++k) advance(still, 1e-3, friction, std::atan(mu) - 1e-6);
  EXPECT_LT(std::abs(still.velocity[0]), 1e-16);  // rounding of an impulse of 1e-3 N s, which the next takes back
  EXPECT_LT(std::abs(still.position[0]), 1e-16);
  const double slope = std::atan(mu) + 0.1;
  Block sliding;
  for (int k = 0; k < 1000; ++k) advance(sliding, 1e-3, friction, slope);
  const double acceleration = gravity * (std::sin(slope) - mu * std::cos(slope));
  EXPECT_NEAR(sliding.velocity[0], -acceleration, 1e-12);  // after 1 s: the step is exact, rounding of 1000 sums
  EXPECT_NEAR(sliding.position[0], -0.5 * acceleration, 1e-12);
}

// Dropped with a horizontal speed: the normal impulse takes m g t, friction mu times that from the horizontal momentum.
TEST(Friction, OfALandingTakesMomentumInProportionToTheBlow) {
  const double height = 0.02, speed = 0.9, mu = 0.25;
  const double blow = std::sqrt(2.0 * gravity * height);
  std::vector<double> errors;
  for (const double step : {1e-4, 1e-5}) {
    Block block{.position = vector(0.0, height), .velocity = vector(speed, 0.0)};
    while (block.velocity[1] <= 0.0 && block.position[1] > 0.0) advance(block, step, {mu, mu});
    while (block.velocity[1] < -1e-9) advance(block, step, {mu, mu});
    errors.push_back(std::abs(block.velocity[0] - (speed - mu * blow)));
    // The step that lands ends at most one and a half steps after the ground is passed, and weight acts until then.
    EXPECT_LT(errors.back(), 1.5 * mu * gravity * step + 1e-9);
    EXPECT_NEAR(block.friction_work + block.impact_work,
                0.5 * mass * speed * speed + mass * gravity * (height - block.position[1]) -
                    0.5 * mass * block.velocity.squaredNorm(),
                1e-14);
  }
}

// A block on a shaken plane creeps where friction differs with the direction. Second route: Runge-Kutta with friction
// that grows as tanh(v / v0) instead of jumping, for smaller and smaller v0.
TEST(Friction, LetsAShakenBlockCreepAsASmoothLawOfFrictionDoes) {
  const double amplitude = 7.0, frequency = 10.0;  // m/s^2, Hz
  const DirectionalFriction friction{.along = 0.2, .against = 0.5};
  const auto drive = [&](double time) { return amplitude * std::sin(2.0 * pi * frequency * time); };
  const int periods = 20, settled = 5;

  const auto stepped = [&](int steps) {
    Block block;
    double from = 0.0;
    const double step = 1.0 / frequency / steps;
    for (int k = 0; k < periods * steps; ++k) {
      if (k == settled * steps) from = block.position[0];
      advance(block, step, friction, 0.0, drive((k + 0.5) * step));
    }
    return (block.position[0] - from) * frequency / (periods - settled);
  };
  const auto smooth = [&](double v0) {
    const auto slope = [&](double time, double v) {
      const double t = std::tanh(v / v0);
      return drive(time) - gravity * (v > 0.0 ? friction.along : friction.against) * t;
    };
    double x = 0.0, v = 0.0, from = 0.0;
    const int steps = 40000;
    const double h = 1.0 / frequency / steps;
    for (int k = 0; k < periods * steps; ++k) {
      if (k == settled * steps) from = x;
      const double time = k * h;
      const double a = slope(time, v), b = slope(time + 0.5 * h, v + 0.5 * h * a);
      const double c = slope(time + 0.5 * h, v + 0.5 * h * b), d = slope(time + h, v + h * c);
      x += h * (v + h / 6.0 * (a + b + c));
      v += h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
    }
    return (x - from) * frequency / (periods - settled);
  };

  const double exact = stepped(16000);
  EXPECT_GT(exact, 0.01);  // it creeps along +x, where friction is low
  const double coarse = std::abs(stepped(500) - exact), fine = std::abs(stepped(2000) - exact);
  EXPECT_LT(fine, 0.35 * coarse);  // first order: a quarter
  EXPECT_LT(fine, 2e-3 * exact);
  // The width of the smooth law is all that it errs by: halving it takes a little less than half off, as v0 log v0
  // does.
  double before = std::abs(smooth(2e-3) - exact);
  for (const double v0 : {1e-3, 5e-4, 2.5e-4}) {
    const double error = std::abs(smooth(v0) - exact);
    EXPECT_GT(before / error, 1.5) << v0;
    EXPECT_LT(before / error, 2.2) << v0;
    before = error;
  }
  EXPECT_LT(before, 0.01 * exact);
}

}  // namespace
}  // namespace coilwright::mechanics
