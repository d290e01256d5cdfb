#include "coilwright/mechanics/planar_chain.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

namespace coilwright::mechanics {
namespace {

JointVector joint_vector(std::initializer_list<double> values) {
  JointVector out(static_cast<Eigen::Index>(values.size()));
  int i = 0;
  for (double v : values) out[i++] = v;
  return out;
}

std::vector<Link> uneven_links() {
  return {{.length = 0.011, .com_along = 0.004, .com_offset = 0.009, .mass = 0.017, .inertia = 2.1e-7},
          {.length = 0.014, .com_along = 0.006, .com_offset = -0.003, .mass = 0.023, .inertia = 3.3e-7},
          {.length = 0.008, .com_along = 0.0095, .com_offset = 0.0125, .mass = 0.012, .inertia = 1.7e-7}};
}

void expect_message(const std::function<void()>& action, const std::string& text) {
  try {
    action();
    FAIL() << "nothing was thrown";
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(std::string(error.what()), text);
  }
}

// The paper's (10)-(12), typed from the paper, without the k and b terms.
struct PaperFinger {
  double l1 = 3.6e-3, l2 = 9.1e-3, h = 11.5e-3, m1 = 16.5e-3, m2 = 22.5e-3, g = 9.81;

  [[nodiscard]] PlanarChain chain() const {
    const std::vector<Link> links{{.length = 2 * l1, .com_along = l1, .com_offset = h, .mass = m1},
                                  {.length = 0.0303, .com_along = l2, .com_offset = h, .mass = m2}};
    return PlanarChain(links, g);
  }
};

TEST(PlanarChain, IsThePapersTwoJointFingerToRounding) {
  const PaperFinger p;
  const PlanarChain chain = p.chain();
  const double t1 = 0.37, t2 = -0.83, w1 = 5.3, w2 = -11.7;
  const JointVector angles = joint_vector({t1, t2});
  const JointVector rates = joint_vector({w1, w2});

  const JointMatrix mass = chain.mass_matrix(angles);
  const double m12 = p.m2 * (p.h * p.h + p.l2 * p.l2 + 2 * p.l1 * p.l2 * std::cos(t2) + 2 * p.h * p.l1 * std::sin(t2));
  const double m11 =
      p.m1 * (p.h * p.h + p.l1 * p.l1) + p.m2 * (p.h * p.h + 4 * p.l1 * p.l1 + p.l2 * p.l2 +
                                                 4 * p.l1 * p.l2 * std::cos(t2) + 4 * p.h * p.l1 * std::sin(t2));
  const double ten_eps = 2.2e-15;
  EXPECT_NEAR(mass(0, 0), m11, ten_eps * m11);
  EXPECT_NEAR(mass(0, 1), m12, ten_eps * m11);
  EXPECT_NEAR(mass(1, 0), m12, ten_eps * m11);
  EXPECT_NEAR(mass(1, 1), p.m2 * (p.h * p.h + p.l2 * p.l2), ten_eps * m11);

  const double coriolis = 2 * p.l1 * p.m2 * (p.h * std::cos(t2) - p.l2 * std::sin(t2));
  const JointVector velocity = chain.velocity_torques(angles, rates);
  const double scale = coriolis * w2 * w2;
  EXPECT_NEAR(velocity[0], 2 * coriolis * w1 * w2 + coriolis * w2 * w2, ten_eps * scale);
  EXPECT_NEAR(velocity[1], -coriolis * w1 * w1, ten_eps * scale);

  const JointVector gravity = chain.gravity_torques(angles);
  const double g2 = p.g * p.m2 * (-p.h * std::cos(t1 + t2) + p.l2 * std::sin(t1 + t2));
  const double g1 =
      p.g * p.m1 * (-p.h * std::cos(t1) + p.l1 * std::sin(t1)) + p.g * p.m2 * 2 * p.l1 * std::sin(t1) + g2;
  EXPECT_NEAR(gravity[0], g1, ten_eps * p.g * p.m2 * p.h * 2);
  EXPECT_NEAR(gravity[1], g2, ten_eps * p.g * p.m2 * p.h * 2);
}

// Kinetic energy from velocities of the centres of mass, by central differences of positions along the motion.
TEST(PlanarChain, KineticEnergyIsThatOfItsMovingMasses) {
  const std::vector<Link> links = uneven_links();
  const PlanarChain chain(links, 9.81);
  const JointVector angles = joint_vector({0.31, -0.52, 0.77});
  const JointVector rates = joint_vector({3.1, -4.7, 6.3});
  const double dt = 1e-6;
  double energy = 0.0;
  double absolute_rate = 0.0;
  for (int i = 0; i < 3; ++i) {
    absolute_rate += rates[i];
    const LinkPoint com{.link = i, .along = links[i].com_along, .offset = links[i].com_offset};
    const Eigen::Vector2d velocity =
        (chain.position(com, angles + dt * rates) - chain.position(com, angles - dt * rates)) / (2 * dt);
    energy += 0.5 * links[i].mass * velocity.squaredNorm() + 0.5 * links[i].inertia * absolute_rate * absolute_rate;
  }
  // Central differences: truncation (omega dt)^2 / 6 = 2e-11, rounding eps / (omega dt) = 2e-11.
  EXPECT_NEAR(chain.kinetic_energy(angles, rates), energy, 1e-9 * energy);
}

TEST(PlanarChain, FramesPutPointsWherePositionsAre) {
  const PlanarChain chain(uneven_links(), 9.81, 0.4);
  const JointVector angles = joint_vector({0.31, -0.52, 0.77});
  const LinkFrames frames = chain.frames(angles);
  for (int link = -1; link < 3; ++link) {
    const LinkPoint point{.link = link, .along = 7.3e-3, .offset = -2.9e-3};
    const Eigen::Vector2d at = frames[static_cast<std::size_t>(link + 1)].at(point.along, point.offset);
    EXPECT_LT((at - chain.position(point, angles)).norm(), 1e-17);  // an eps of a few centimetres
  }
}

TEST(PlanarChain, GravityTorqueIsTheSlopeOfPotentialEnergyAlsoOnATiltedBase) {
  const PlanarChain chain(uneven_links(), 9.79, 0.23);
  const JointVector angles = joint_vector({0.31, -0.52, 0.77});
  const JointVector torque = chain.gravity_torques(angles);
  const JointMatrix stiffness = chain.gravity_stiffness(angles);
  const double step = 1e-5;
  for (int i = 0; i < 3; ++i) {
    JointVector ahead = angles;
    JointVector behind = angles;
    ahead[i] += step;
    behind[i] -= step;
    const double slope = (chain.potential_energy(ahead) - chain.potential_energy(behind)) / (2 * step);
    EXPECT_NEAR(torque[i], slope, 1e-8 * torque.norm());  // rounding eps V / step = 1e-11 of V
    const JointVector column = (chain.gravity_torques(ahead) - chain.gravity_torques(behind)) / (2 * step);
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(stiffness(j, i), column[j], 1e-8 * stiffness.norm());
  }
}

TEST(PlanarChain, PotentialEnergyIsWeightTimesHeight) {
  const std::vector<Link> links = uneven_links();
  const PlanarChain chain(links, 9.79);
  const JointVector angles = joint_vector({0.31, -0.52, 0.77});
  double energy = 0.0;
  for (int i = 0; i < 3; ++i)
    energy += links[i].mass * 9.79 *
              chain.position({.link = i, .along = links[i].com_along, .offset = links[i].com_offset}, angles).y();
  EXPECT_NEAR(chain.potential_energy(angles), energy, 1e-14 * std::abs(energy) + 1e-18);
}

TEST(PlanarChain, TiltTurnsGravityLikeTheFirstJointWould) {
  const PlanarChain tilted(uneven_links(), 9.81, 0.4);
  const PlanarChain level(uneven_links(), 9.81);
  const JointVector at = joint_vector({0.1, -0.2, 0.3});
  const JointVector turned = joint_vector({0.5, -0.2, 0.3});
  EXPECT_LT((tilted.gravity_torques(at) - level.gravity_torques(turned)).norm(), 1e-17);
}

TEST(PlanarChain, JacobianIsTheSlopeOfPosition) {
  const PlanarChain chain(uneven_links(), 9.81);
  const JointVector angles = joint_vector({0.31, -0.52, 0.77});
  const LinkPoint tip{.link = 2, .along = 0.021, .offset = 0.004};
  const PointJacobian slope = chain.jacobian(tip, angles);
  const PointJacobian by_frames = chain.jacobian(tip, chain.frames(angles));
  EXPECT_LT((by_frames - slope).norm(), 1e-14 * slope.norm());
  for (int i = 0; i < 3; ++i) {
    JointVector ahead = angles;
    JointVector behind = angles;
    ahead[i] += 1e-5;
    behind[i] -= 1e-5;
    const Eigen::Vector2d difference = (chain.position(tip, ahead) - chain.position(tip, behind)) / 2e-5;
    EXPECT_LT((slope.col(i) - difference).norm(), 1e-9 * slope.norm());  // truncation step^2 / 6
  }
}

TEST(PlanarChain, HasVelocityAndGravityTorquesTogetherOrApart) {
  const PlanarChain chain(uneven_links(), 9.81, 0.4);
  const JointVector angles = joint_vector({0.31, -0.52, 0.77});
  const JointVector rates = joint_vector({3.0, -7.0, 5.0});
  const JointVector apart = chain.velocity_torques(angles, rates) + chain.gravity_torques(angles);
  EXPECT_LT((chain.bias_torques(angles, rates) - apart).norm(), 1e-14 * apart.norm());
}

// d(T + V)/dt along the equations of motion must vanish: T'' from the accelerations under test, T and V from the
// energies.
TEST(PlanarChain, ConservesEnergyWithoutTorques) {
  const PlanarChain chain(uneven_links(), 9.81, 0.1);
  JointVector angles = joint_vector({0.9, -0.4, 1.3});
  JointVector rates = joint_vector({2.0, -3.0, 5.0});
  const JointVector none = JointVector::Zero(3);
  const auto energy = [&] { return chain.kinetic_energy(angles, rates) + chain.potential_energy(angles); };
  const double before = energy();
  const double kinetic = chain.kinetic_energy(angles, rates);

  std::vector<double> drift;
  for (const double step : {2e-4, 1e-4}) {
    angles = joint_vector({0.9, -0.4, 1.3});
    rates = joint_vector({2.0, -3.0, 5.0});
    for (int i = 0; i < std::lround(0.4 / step); ++i) {  // classical Runge-Kutta, written here only
      const JointVector a1 = chain.accelerations(angles, rates, none);
      const JointVector r2 = rates + 0.5 * step * a1;
      const JointVector a2 = chain.accelerations(angles + 0.5 * step * rates, r2, none);
      const JointVector r3 = rates + 0.5 * step * a2;
      const JointVector a3 = chain.accelerations(angles + 0.5 * step * r2, r3, none);
      const JointVector r4 = rates + step * a3;
      const JointVector a4 = chain.accelerations(angles + step * r3, r4, none);
      angles += step / 6.0 * (rates + 2 * r2 + 2 * r3 + r4);
      rates += step / 6.0 * (a1 + 2 * a2 + 2 * a3 + a4);
    }
    drift.push_back(std::abs(energy() - before) / kinetic);
  }
  EXPECT_LT(drift[1], 1e-6);
  EXPECT_LT(drift[1], drift[0] / 10.0);  // fourth order or better: the drift is the stepper's, not the model's
}

TEST(PlanarChain, SolvesTheEquationOfMotion) {
  const PlanarChain chain(uneven_links(), 9.81);
  const JointVector angles = joint_vector({0.31, -0.52, 0.77});
  const JointVector rates = joint_vector({3.1, -4.7, 6.3});
  const JointVector torques = joint_vector({0.011, -0.007, 0.003});
  const JointVector residual = chain.mass_matrix(angles) * chain.accelerations(angles, rates, torques) +
                               chain.velocity_torques(angles, rates) + chain.gravity_torques(angles) - torques;
  EXPECT_LT(residual.norm(), 1e-14 * torques.norm() * 10);
}

TEST(PlanarChain, IsTheSameChainUnderAnotherGravity) {
  const PlanarChain chain(uneven_links(), 9.81, 0.1);
  const PlanarChain turned = chain.under_gravity(1.62, -0.4);
  const PlanarChain direct(uneven_links(), 1.62, -0.4);
  const JointVector angles = joint_vector({0.31, -0.52, 0.77});
  EXPECT_EQ(turned.gravity_torques(angles), direct.gravity_torques(angles));
  EXPECT_EQ(turned.mass_matrix(angles), chain.mass_matrix(angles));
}

TEST(PlanarChain, TakesOtherLinksUnderTheSameGravity) {
  const PlanarChain chain(uneven_links(), 1.62, 0.1);
  std::vector<Link> links(chain.links().begin(), chain.links().end());
  ASSERT_EQ(links.size(), 3U);
  links.back().mass += 0.02;
  const PlanarChain laden = chain.with_links(links);
  const PlanarChain direct(links, 1.62, 0.1);
  const JointVector angles = joint_vector({0.31, -0.52, 0.77});
  EXPECT_EQ(laden.gravity_torques(angles), direct.gravity_torques(angles));
  EXPECT_NE(laden.gravity_torques(angles), chain.gravity_torques(angles));
}

// A torque at one joint alone, from rest and without gravity.
TEST(PlanarChain, GivesWayAtAJointByItsMobility) {
  const PlanarChain chain(uneven_links(), 0.0);
  const JointVector still = JointVector::Zero(3);
  for (int j = 0; j < 3; ++j) {
    JointVector torque = still;
    torque[j] = 0.013;
    const double acceleration = chain.accelerations(still, still, torque)[j];
    EXPECT_NEAR(chain.joint_mobility()[j] * 0.013, acceleration, 1e-12 * acceleration);
  }
}

// Lagrange's equations by differences of the energies, with a rotor's J theta_j'^2 / 2 written down beside them: the
// torque that an acceleration takes is what is left of d/dt(dT/dtheta') - dT/dtheta + dV/dtheta.
TEST(PlanarChain, TurnsARotorWithItsJoint) {
  std::vector<Link> links = uneven_links();
  const PlanarChain bare(links, 9.81, 0.2);
  const JointVector rotors = joint_vector({1.3e-6, 0.0, 2.7e-6});
  for (int j = 0; j < 3; ++j) links[static_cast<std::size_t>(j)].rotor_inertia = rotors[j];
  const PlanarChain chain(links, 9.81, 0.2);
  const JointVector angles = joint_vector({0.31, -0.52, 0.77});
  const JointVector rates = joint_vector({3.1, -4.7, 6.3});
  const JointVector torques = joint_vector({0.011, -0.007, 0.003});
  const JointVector accelerations = chain.accelerations(angles, rates, torques);
  const auto kinetic = [&](const JointVector& at, const JointVector& speed) {
    return bare.kinetic_energy(at, speed) + 0.5 * rotors.dot(speed.cwiseProduct(speed));
  };
  EXPECT_NEAR(chain.kinetic_energy(angles, rates), kinetic(angles, rates), 1e-14 * kinetic(angles, rates));
  const double step = 1e-5;
  const auto momentum = [&](const JointVector& at, const JointVector& speed, int j) {
    JointVector d = JointVector::Zero(3);
    d[j] = step;
    return (kinetic(at, speed + d) - kinetic(at, speed - d)) / (2.0 * step);
  };
  for (int j = 0; j < 3; ++j) {
    JointVector d = JointVector::Zero(3);
    d[j] = step;
    const double time = 1e-5;
    const double rise = (momentum(angles + time * rates, rates + time * accelerations, j) -
                         momentum(angles - time * rates, rates - time * accelerations, j)) /
                        (2.0 * time);
    const double fall = (kinetic(angles + d, rates) - kinetic(angles - d, rates)) / (2.0 * step);
    const double weight = (bare.potential_energy(angles + d) - bare.potential_energy(angles - d)) / (2.0 * step);
    EXPECT_NEAR(rise - fall + weight, torques[j], 1e-6 * torques.norm()) << j;
  }
  EXPECT_LT((chain.slopes(angles, rates, accelerations).by_acceleration - chain.mass_matrix(angles)).norm(),
            1e-14 * chain.mass_matrix(angles).norm());
  // A rotor at the first joint is inertia of the first link, and at no other joint.
  std::vector<Link> heavier = uneven_links();
  heavier[0].inertia += rotors[0];
  links = uneven_links();
  links[0].rotor_inertia = rotors[0];
  EXPECT_LT((PlanarChain(links).mass_matrix(angles) - PlanarChain(heavier).mass_matrix(angles)).norm(), 1e-19);
  links[0].rotor_inertia = -1.0;
  expect_message([&] { PlanarChain refused(links); }, "link 0: rotor_inertia must be finite and >= 0; got -1");
}

TEST(PlanarChain, RefusesWhatIsNotAChain) {
  expect_message([] { PlanarChain chain{std::vector<Link>{}}; }, "links: 1 to 16 are supported; got 0");
  auto links = uneven_links();
  links[1].mass = -0.5;
  expect_message([&] { PlanarChain chain(links); }, "link 1: mass must be finite and > 0; got -0.5");
  links = uneven_links();
  links[2].inertia = std::nan("");
  expect_message([&] { PlanarChain chain(links); }, "link 2: inertia must be finite and >= 0; got nan");
  links = uneven_links();
  links[2] = {.length = 0.01, .com_along = 0.0, .com_offset = 0.0, .mass = 0.2, .inertia = 0.0};
  expect_message([&] { PlanarChain chain(links); },
                 "link 2: must have a finite moment of inertia > 0 about its joint; got 0");
  expect_message([&] { PlanarChain chain(uneven_links(), -1.0); }, "gravity must be finite and >= 0; got -1");
}

// Against differences of the equation itself, with the chain tilted and every term at work.
TEST(PlanarChain, HasTheSlopesThatItsEquationShows) {
  const PlanarChain chain(uneven_links(), 9.81, 0.37);
  const JointVector angles = joint_vector({0.41, -0.23, 0.68});
  const JointVector rates = joint_vector({3.7, -5.1, 2.3});
  const JointVector accelerations = joint_vector({240.0, -710.0, 390.0});
  const auto torques = [&](const JointVector& at, const JointVector& moving) {
    return JointVector(chain.mass_matrix(at) * accelerations + chain.velocity_torques(at, moving) +
                       chain.gravity_torques(at));
  };
  const ChainSlopes slopes = chain.slopes(angles, rates, accelerations);
  EXPECT_LT((slopes.by_acceleration - chain.mass_matrix(angles)).norm(), 1e-20);
  constexpr double step = 1e-5;
  for (int j = 0; j < 3; ++j) {
    JointVector shift = JointVector::Zero(3);
    shift[j] = step;
    const JointVector by_angle = (torques(angles + shift, rates) - torques(angles - shift, rates)) / (2.0 * step);
    const JointVector by_rate = (torques(angles, rates + shift) - torques(angles, rates - shift)) / (2.0 * step);
    // Torques of 1e-2 N m: rounding 1e-18 over the step, and the step squared of their third slope.
    EXPECT_LT((slopes.by_angle.col(j) - by_angle).norm(), 1e-11) << j;
    EXPECT_LT((slopes.by_rate.col(j) - by_rate).norm(), 1e-11) << j;
  }
}

}  // namespace
}  // namespace coilwright::mechanics
