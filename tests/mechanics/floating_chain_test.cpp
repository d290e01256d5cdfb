#include "coilwright/mechanics/floating_chain.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <vector>

#include "coilwright/mechanics/moreau_step.hpp"
#include "error_text.hpp"
#include "mechanics/coordinates.hpp"

namespace coilwright::mechanics {
namespace {

std::vector<Link> floating_links() {
  return {{.length = 0.031, .com_along = 0.013, .com_offset = 0.007, .mass = 0.041, .inertia = 6.1e-6},
          {.length = 0.011, .com_along = 0.004, .com_offset = 0.009, .mass = 0.017, .inertia = 2.1e-7},
          {.length = 0.014, .com_along = 0.006, .com_offset = -0.003, .mass = 0.023, .inertia = 3.3e-7}};
}

const CoordinateVector pose = coordinates({0.013, -0.021, -1.2, 0.43, -0.71});
const CoordinateVector rates = coordinates({0.31, -0.17, 2.3, -5.1, 7.7});

// With the base held as PlanarChain holds it (base angle 0, the first joint at its front end) the joints' part of every
// term is PlanarChain's, which works in absolute angles.
TEST(FloatingChain, IsThePlanarChainWhereItsBaseIsHeld) {
  const std::vector<Link> links = floating_links();
  const FloatingChain floating(links, 9.79);
  const PlanarChain held(std::span<const Link>(links).subspan(1), 9.79);
  const JointVector angles = pose.tail(2), speeds = rates.tail(2);
  CoordinateVector at = pose, moving = rates;
  at[2] = 0.0;
  moving.head(3).setZero();
  const FloatingFrames frames = floating.frames(at);
  const double ten_eps = 2.2e-15;
  const JointMatrix mass = held.mass_matrix(angles);
  EXPECT_LT((floating.mass_matrix(frames).bottomRightCorner(2, 2) - mass).norm(), ten_eps * mass.norm());
  const JointVector velocity = held.velocity_torques(angles, speeds);
  EXPECT_LT((floating.velocity_forces(frames, moving).tail(2) - velocity).norm(), 10 * ten_eps * velocity.norm());
  const JointVector gravity = held.gravity_torques(angles);
  EXPECT_LT((floating.gravity_forces(frames).tail(2) - gravity).norm(), 10 * ten_eps * gravity.norm());
  const JointVector both = velocity + gravity;
  EXPECT_LT((floating.bias_forces(frames, moving).tail(2) - both).norm(), 10 * ten_eps * both.norm());
}

TEST(FloatingChain, HasTheSlopesOfItsPositionsAndOfItsPotentialEnergy) {
  const FloatingChain chain(floating_links(), 9.79);
  const LinkPoint point{.link = 2, .along = 0.021, .offset = 0.004};
  const FloatingJacobian slope = chain.jacobian(chain.frames(pose), point);
  const CoordinateVector gravity = chain.gravity_forces(chain.frames(pose));
  for (int i = 0; i < 5; ++i) {
    CoordinateVector ahead = pose, behind = pose;
    ahead[i] += 1e-5;
    behind[i] -= 1e-5;
    const FloatingFrames a = chain.frames(ahead), b = chain.frames(behind);
    EXPECT_LT((slope.col(i) - (chain.position(a, point) - chain.position(b, point)) / 2e-5).norm(), 1e-9);
    EXPECT_NEAR(gravity[i], (chain.potential_energy(a) - chain.potential_energy(b)) / 2e-5, 1e-9);
  }
}

// Lagrange: c = dM/dt v - dT/dq, by differences of the mass matrix.
TEST(FloatingChain, HasTheVelocityForcesOfItsKineticEnergy) {
  const FloatingChain chain(floating_links(), 9.79);
  const double step = 1e-5;
  const auto mass = [&](const CoordinateVector& at) { return chain.mass_matrix(chain.frames(at)); };
  CoordinateVector expected = (mass(pose + step * rates) - mass(pose - step * rates)) * rates / (2 * step);
  for (int i = 0; i < 5; ++i) {
    CoordinateVector shift = CoordinateVector::Zero(5);
    shift[i] = step;
    expected[i] -= 0.5 * rates.dot((mass(pose + shift) - mass(pose - shift)) * rates) / (2 * step);
  }
  const CoordinateVector velocity = chain.velocity_forces(chain.frames(pose), rates);
  EXPECT_LT((velocity - expected).norm(), 1e-7 * velocity.norm());  // (rate step)^2 = 6e-9
}

// In free flight momentum and angular momentum about the centre of mass stay, and energy does: checked from positions
// of the centres of mass alone. The midpoint rule's errors shrink with the square of the step.
TEST(FloatingChain, ConservesWhatAFreeFlightConserves) {
  const std::vector<Link> links = floating_links();
  const FloatingChain chain(links, 9.79);
  struct Kept {
    double energy, horizontal, vertical, spin;
  };
  const auto kept = [&](const CoordinateVector& at, const CoordinateVector& moving, double time) {
    const FloatingFrames frames = chain.frames(at);
    Eigen::Vector2d centre = Eigen::Vector2d::Zero(), momentum = centre;
    double about_origin = 0.0, absolute = 0.0;
    for (int i = 0; i < 3; ++i) {
      const LinkPoint com{.link = i, .along = links[i].com_along, .offset = links[i].com_offset};
      const Eigen::Vector2d place = chain.position(frames, com), speed = chain.jacobian(frames, com) * moving;
      absolute += moving[2 + i];
      centre += links[i].mass * place;
      momentum += links[i].mass * speed;
      about_origin += links[i].mass * (place.x() * speed.y() - place.y() * speed.x()) + links[i].inertia * absolute;
    }
    centre /= chain.mass();
    return Kept{chain.kinetic_energy(frames, moving) + chain.potential_energy(frames), momentum.x(),
                momentum.y() + chain.mass() * 9.79 * time,
                about_origin - (centre.x() * momentum.y() - centre.y() * momentum.x())};
  };
  const auto errors = [&](double step) {
    CoordinateVector at = pose, moving = rates;
    const Kept before = kept(at, moving, 0.0);
    const double kinetic = chain.kinetic_energy(chain.frames(at), moving);
    const int steps = static_cast<int>(std::lround(0.3 / step));
    for (int k = 0; k < steps; ++k) {
      const MoreauStep next =
          moreau_step(at, moving, step, [&](const CoordinateVector& middle, const CoordinateVector& start) {
            const FloatingFrames frames = chain.frames(middle);
            return MiddleOfStep{
                chain.mass_matrix(frames), -chain.velocity_forces(frames, start) - chain.gravity_forces(frames), {}};
          });
      at = next.position;
      moving = next.velocity;
    }
    const Kept after = kept(at, moving, steps * step);
    return std::vector<double>{std::abs(after.energy - before.energy) / kinetic,
                               std::abs(after.horizontal - before.horizontal) / (chain.mass() * 0.3),
                               std::abs(after.vertical - before.vertical) / (chain.mass() * 0.3),
                               std::abs(after.spin - before.spin) / std::abs(before.spin)};
  };
  const std::vector<double> coarse = errors(2e-5), fine = errors(1e-5);
  for (int i = 0; i < 4; ++i) {
    EXPECT_LT(fine[i], 1e-3) << i;
    // The velocity forces are taken at the start of the step: first order.
    EXPECT_LT(fine[i], 0.6 * coarse[i] + 1e-12) << i;
  }
}

// One link that swings about its own joint, small: the period of a physical pendulum.
TEST(FloatingChain, SwingsAsAPendulumWhenItsJointIsHeld) {
  const double m = 0.03, l = 0.05, inertia = 4e-6, g = 9.81;
  const FloatingChain chain(
      std::vector<Link>{{.length = 0.1, .com_along = l, .com_offset = 0.0, .mass = m, .inertia = inertia}}, g);
  const double period = 2.0 * 3.14159265358979323846 * std::sqrt((m * l * l + inertia) / (m * g * l));
  CoordinateVector at = coordinates({0.0, 0.0, 1e-3}), moving = CoordinateVector::Zero(3);
  const int steps = 2000;
  for (int k = 0; k < steps; ++k) {
    const FloatingFrames frames = chain.frames(at + 0.5 * period / steps * moving);
    const double torque = -chain.gravity_forces(frames)[2] - chain.velocity_forces(frames, moving)[2];
    const double before = moving[2];
    moving[2] += period / steps * torque / chain.mass_matrix(frames)(2, 2);
    at[2] += 0.5 * period / steps * (before + moving[2]);
  }
  EXPECT_NEAR(at[2], 1e-3, 1e-8);  // (pi / 1000)^2 of the rule, and the square of the amplitude
}

TEST(FloatingChain, RefusesWhatIsNoChain) {
  EXPECT_EQ(error_text([] { FloatingChain chain{std::vector<Link>{}}; }), "links: 1 to 17 are supported; got 0");
  std::vector<Link> links = floating_links();
  links[1].mass = 0.0;
  EXPECT_EQ(error_text([&] { FloatingChain chain(links); }), "link 1: mass must be finite and > 0; got 0");
}

}  // namespace
}  // namespace coilwright::mechanics
