#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>
#include <string_view>
#include <utility>
#include <vector>

#include "actuator/effects/rig.hpp"
#include "coilwright/actuator/model/model.hpp"

namespace coilwright::actuator {
namespace {

Model with(std::string_view id, Numbers values, ModelSpec spec) {
  spec.effects = {{.kind = standard_effects().find(id), .values = std::move(values)}};
  return Model(std::move(spec));
}

// A state of joints and bodies, and where it goes.
struct Motion {
  JointVector angles;
  JointVector rates;
  Numbers internal;
};
Motion slope_of(const Model& model, const Motion& at, double current) {
  Motion out{.angles = at.rates, .rates = JointVector::Zero(model.joints()), .internal = at.internal};
  model.derivative(at.angles, at.rates, at.internal, model.all_coils(current), JointVector::Zero(model.joints()),
                   out.rates, out.internal);
  return out;
}
Motion moved(Motion at, const Motion& slope, double time) {
  at.angles += time * slope.angles;
  at.rates += time * slope.rates;
  for (std::size_t i = 0; i < at.internal.size(); ++i) at.internal[i] += time * slope.internal[i];
  return at;
}

// Central difference of a function of the state along its motion, per second.
template <typename Function>
double growth(const Motion& at, const Motion& slope, Function&& function) {
  constexpr double step = 1e-6;
  return (function(moved(at, slope, step)) - function(moved(at, slope, -step))) / (2.0 * step);
}

class RandomMotion {
 public:
  Motion operator()(int joints, double displacement) {
    Motion out{.angles = JointVector(joints), .rates = JointVector(joints), .internal = {}};
    for (int j = 0; j < joints; ++j) out.angles[j] = 0.4 + 0.4 * any_(random_), out.rates[j] = 8.0 * any_(random_);
    out.internal = {displacement * any_(random_), 100.0 * displacement * any_(random_)};
    return out;
  }

 private:
  std::mt19937_64 random_{20240314};
  std::uniform_real_distribution<double> any_{-1.0, 1.0};
};

constexpr double mount_frequency = 47.0;
constexpr double mount_ratio = 0.37;

ModelSpec frictionless(Configuration configuration) {
  ModelSpec spec = finger(configuration);
  for (Hinge& hinge : spec.hinges) hinge.damping = 0.0, hinge.contact = {};
  return spec;
}

double mass_of(const mechanics::PlanarChain& chain) {
  double sum = 0.0;
  for (const mechanics::Link& link : chain.links()) sum += link.mass;
  return sum;
}

// Link by link, the mount's rate added to that of each centre of mass.
struct Sums {
  double momentum{};  // N s, across the chain
  double kinetic{};   // J
};
Sums sums(const mechanics::PlanarChain& chain, const Motion& at) {
  const double mount = at.internal[1];
  const double mount_mass = mass_of(chain) / mount_ratio;
  Sums out{.momentum = mount_mass * mount, .kinetic = 0.5 * mount_mass * mount * mount};
  double turning = 0.0;
  for (int j = 0; j < chain.joints(); ++j) {
    const mechanics::Link& link = chain.link(j);
    turning += at.rates[j];
    const mechanics::LinkPoint centre{.link = j, .along = link.com_along, .offset = link.com_offset};
    Eigen::Vector2d velocity = chain.jacobian(centre, at.angles) * at.rates;
    velocity.x() += mount;
    out.momentum += link.mass * velocity.x();
    out.kinetic += 0.5 * link.mass * velocity.squaredNorm() + 0.5 * link.inertia * turning * turning;
  }
  return out;
}

// What changes the momentum across the chain is the mount's spring and damper alone: gravity pulls along it.
void expect_balance_of_momentum(const Model& model, double damping_ratio) {
  RandomMotion random;
  const double mass = mass_of(model.chain()) * (1.0 + 1.0 / mount_ratio);
  const double omega = 2.0 * M_PI * mount_frequency;
  for (int i = 0; i < 20; ++i) {
    const Motion at = random(model.joints(), 1e-4);
    const double rate =
        growth(at, slope_of(model, at, 0.0), [&](const Motion& m) { return sums(model.chain(), m).momentum; });
    const double force = -mass * (omega * omega * at.internal[0] + 2.0 * damping_ratio * omega * at.internal[1]);
    EXPECT_NEAR(rate, force, 1e-6 * (1.0 + std::abs(force)));  // of the difference's 1e-12 s^2
  }
}

TEST(MountCompliance, KeepsTheBalanceOfMomentum) {
  for (const Configuration configuration : {Configuration::B, Configuration::C})
    expect_balance_of_momentum(with("mount_compliance", {mount_frequency, mount_ratio}, frictionless(configuration)),
                               0.05);
}

TEST(MountCompliance, IsDampedAsItsFurtherNumberSays) {
  for (const double damping_ratio : {0.004, 0.31}) {
    ModelSpec spec = frictionless(Configuration::B);
    spec.effects = {{.kind = standard_effects().find("mount_compliance")->with_further_numbers(),
                     .values = {mount_frequency, mount_ratio, damping_ratio}}};
    expect_balance_of_momentum(Model(spec), damping_ratio);
  }
}

TEST(MountCompliance, KeepsTheBalanceOfEnergy) {
  RandomMotion random;
  const ModelSpec spec = frictionless(Configuration::C);
  const Model model = with("mount_compliance", {mount_frequency, mount_ratio}, spec);
  const double mass = mass_of(model.chain()) * (1.0 + 1.0 / mount_ratio);
  const double omega = 2.0 * M_PI * mount_frequency;
  const auto energy = [&](const Motion& m) {
    double sum = sums(model.chain(), m).kinetic + model.chain().potential_energy(m.angles);
    for (int j = 0; j < model.joints(); ++j)
      sum += 0.5 * spec.hinges[j].stiffness * m.angles[j] * m.angles[j] - spec.hinges[j].torque_offset * m.angles[j];
    return sum + 0.5 * mass * omega * omega * m.internal[0] * m.internal[0];
  };
  for (int i = 0; i < 20; ++i) {
    const Motion at = random(4, 1e-4);
    const double damped = 2.0 * 0.05 * omega * mass * at.internal[1] * at.internal[1];
    JointVector magnets = JointVector::Zero(4);
    model.magnetics().add_torques(model.chain(), at.angles, model.all_coils(0.0), magnets);
    const double expected = magnets.dot(at.rates) - damped;  // magnets that pull at each other
    EXPECT_NEAR(growth(at, slope_of(model, at, 0.0), energy), expected, 1e-6);
  }
}

TEST(MountCompliance, FadesWithTheMassRatio) {
  RandomMotion random;
  const Model firm(finger());
  for (const double ratio : {1e-3, 1e-6}) {
    const Model model = with("mount_compliance", {mount_frequency, ratio}, finger());
    Motion at = random(2, 0.0);
    const JointVector moved_so = slope_of(model, at, 0.7).rates;
    at.internal.clear();
    const JointVector firmly = slope_of(firm, at, 0.7).rates;
    EXPECT_NEAR((moved_so - firmly).norm() / firmly.norm(), 0.0, 5.0 * ratio);
  }
}

// The equations that EffectTerm::Body states, with each body described by a term of its own: two joints and one, two or
// three bodies, and sizes for which nothing is unrolled.
TEST(Bodies, SolveTheirEquationsTogetherWithTheChain) {
  const std::vector<std::vector<std::pair<std::string_view, Numbers>>> rows = {
      {{"mount_compliance", {mount_frequency, mount_ratio}}},
      {{"backlash", {0.02}}},
      {{"backlash", {0.02}}, {"mount_compliance", {mount_frequency, mount_ratio}}}};
  RandomMotion random;
  for (const Configuration configuration : {Configuration::A, Configuration::B, Configuration::C, Configuration::D})
    for (const auto& row : rows) {
      ModelSpec spec = frictionless(configuration);
      const Model alone(spec);
      std::vector<std::unique_ptr<const EffectTerm>> terms;
      for (const auto& [id, values] : row) {
        const EffectKind* kind = standard_effects().find(id);
        spec.effects.push_back({.kind = kind, .values = values});
        terms.push_back(kind->build(values, spec));
      }
      const Model model(spec);
      Motion at = random(model.joints(), 0.0);
      at.internal.clear();
      const JointVector free = slope_of(alone, at, 0.9).rates;
      for (const auto& term : terms)
        for (int i = 0; i < term->states(); ++i) at.internal.push_back(0.007 * std::cos(1.0 + i));
      const Motion slope = slope_of(model, at, 0.9);

      JointVector joints = model.chain().mass_matrix(at.angles) * (slope.rates - free);
      const double largest = (model.chain().mass_matrix(at.angles) * free).cwiseAbs().maxCoeff();
      std::size_t first = 0;
      for (const auto& term : terms) {
        std::vector<EffectTerm::Body> bodies(term->bodies(), {.coupling = JointVector::Zero(model.joints())});
        term->describe_bodies({.chain = model.chain(), .angles = at.angles, .rates = at.rates}, model.all_coils(0.9),
                              &at.internal[first], bodies.data());
        for (std::size_t b = 0; b < bodies.size(); ++b) {
          const double moved_by = slope.internal[first + bodies.size() + b];
          EXPECT_EQ(slope.internal[first + b], at.internal[first + bodies.size() + b]);
          joints += bodies[b].coupling * moved_by;
          EXPECT_NEAR(bodies[b].coupling.dot(slope.rates) + bodies[b].mass * moved_by, bodies[b].force,
                      1e-11 * (std::abs(bodies[b].force) + std::abs(bodies[b].mass * moved_by)));
        }
        first += 2 * bodies.size();
      }
      EXPECT_LT(joints.cwiseAbs().maxCoeff(), 1e-10 * largest) << row.front().first << ", " << model.joints();
    }
}

// A coil of 1 N m/A at every angle on a body of its own.
constexpr double body = 3.1e-6;
ModelSpec driven_rotor() {
  ModelSpec spec = rotor(body);
  const auto flat = [](std::span<const double> /*angles*/, std::span<double> torques) {
    std::fill(torques.begin(), torques.end(), 4e-3);
  };
  HingePair pair{.torque_per_ampere = std::make_shared<const magnetics::Curve>(
                     flat, magnetics::Curve::Spec{.lower = -3.0, .upper = 3.0, .tolerance = 1e-9})};
  spec.magnetics = MagneticStage({std::move(pair)}, {});
  spec.coils = 1;
  return spec;
}
constexpr double gap = 0.7 / 57.29577951308232;
constexpr double firm_gap = 0.01 / 57.29577951308232;
constexpr double free_share = gap / (gap + firm_gap);  // of the magnet that is free
constexpr double magnet_mass = 0.3 * body;

// A torque on a magnet that flies moves no joint; the joint starts when the gap is crossed, sqrt(gap J / q) later.
TEST(Backlash, HoldsTheTorqueBackUntilTheGapIsCrossed) {
  const Model model = with("backlash", {gap}, driven_rotor());
  constexpr double torque = 4e-3;
  Motion at{.angles = JointVector::Zero(1), .rates = JointVector::Zero(1), .internal = {0.0, 0.0}};
  const double flying = slope_of(model, at, 1.0).rates[0];
  EXPECT_NEAR(flying, (1.0 - free_share) * torque / (body - free_share * magnet_mass), 1e-9 * torque / body);
  double crossed = 0.0;
  constexpr double step = 1e-7;
  while (std::abs(at.internal[0]) < 0.5 * gap) at = moved(at, slope_of(model, at, 1.0), step), crossed += step;
  EXPECT_NEAR(crossed, std::sqrt(gap * magnet_mass / torque), 0.01 * crossed);  // Euler, and the firm 1.4 %
  const double together = 0.02;
  for (double time = 0.0; time < together; time += step) at = moved(at, slope_of(model, at, 1.0), step);
  // Momentum: the whole torque has acted on both bodies since the start.
  const double spin = body * at.rates[0] + free_share * magnet_mass * at.internal[1];
  EXPECT_NEAR(spin, torque * (crossed + together), 1e-4 * spin);
  EXPECT_NEAR(slope_of(model, at, 1.0).rates[0], torque / body, 0.01 * torque / body);
}

// Two bodies and what the seat has stored: nothing is won, and nothing lost while the magnet flies.
TEST(Backlash, IsPassiveAtEveryInstant) {
  RandomMotion random;
  const Model model = with("backlash", {gap}, driven_rotor());
  const auto energy = [&](const Motion& m) {
    const double depth = std::max(0.0, std::abs(m.internal[0]) - 0.5 * gap);
    return 0.5 * body * m.rates[0] * m.rates[0] + free_share * magnet_mass * m.rates[0] * m.internal[1] +
           0.5 * free_share * magnet_mass * (m.internal[1] * m.internal[1] + 1500.0 * 1500.0 * depth * depth);
  };
  int flew = 0;
  for (int i = 0; i < 400; ++i) {
    const Motion at = random(1, 1.5 * gap);
    const double lost = -growth(at, slope_of(model, at, 0.0), energy);
    const bool flies = std::abs(at.internal[0]) < 0.49 * gap;
    flew += flies ? 1 : 0;
    if (flies)
      EXPECT_NEAR(lost, 0.0, 1e-9 * energy(at) * 1e3);  // differences of 1e-6 s
    else
      EXPECT_GT(lost, -1e-6 * energy(at) * 1500.0);
  }
  EXPECT_GT(flew, 50);
  EXPECT_LT(flew, 350);
}

TEST(Backlash, RestsPressedIntoItsSeat) {
  const Model model = with("backlash", {gap}, finger());
  const JointVector angles = JointVector::Constant(2, 0.3);
  const InternalStates states = model.settled(angles, model.all_coils(0.8));
  Motion at{.angles = angles, .rates = JointVector::Zero(2), .internal = Numbers(states.begin(), states.end())};
  const Motion slope = slope_of(model, at, 0.8);
  at.internal.clear();
  const Motion firm = slope_of(Model(finger()), at, 0.8);
  // The seat gives the joint the whole torque, but the magnet's inertia stays behind until the seat presses harder.
  const mechanics::JointMatrix mass = model.chain().mass_matrix(angles);
  mechanics::JointMatrix without = mass;
  without.diagonal() -= free_share * 0.3 / 2.0 * model.chain().joint_mobility().cwiseInverse();
  EXPECT_LT((without * slope.rates - mass * firm.rates).norm(), 1e-9 * (mass * firm.rates).norm());
  EXPECT_GT(std::abs(states[0]), 0.5 * gap);
  EXPECT_EQ(model.static_residual(angles, model.all_coils(0.8)),
            Model(finger()).static_residual(angles, model.all_coils(0.8)));
}

// More bodies than one at once: each moves as by itself where they do not touch each other's joints.
TEST(Bodies, MoveTogether) {
  ModelSpec spec = finger();
  spec.effects = {{.kind = standard_effects().find("mount_compliance"), .values = {mount_frequency, 1e-7}},
                  {.kind = standard_effects().find("backlash"), .values = {gap}}};
  const Model both(spec);
  const Model one = with("backlash", {gap}, finger());
  ASSERT_EQ(both.internal_states(), 6);
  JointVector angles(2);
  angles << 0.2, 0.5;
  JointVector rates(2);
  rates << 3.0, -4.0;
  const Motion alone = slope_of(one, {.angles = angles, .rates = rates, .internal = {0.0, 0.01, 2.0, -1.0}}, 0.5);
  const Motion beside =
      slope_of(both, {.angles = angles, .rates = rates, .internal = {0.0, 0.01, 2.0, -1.0, 0.0, 0.0}}, 0.5);
  EXPECT_LT((alone.rates - beside.rates).norm(), 1e-5 * alone.rates.norm());
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(alone.internal[i], beside.internal[i], 1e-5 * alone.rates.norm());
}

}  // namespace
}  // namespace coilwright::actuator
