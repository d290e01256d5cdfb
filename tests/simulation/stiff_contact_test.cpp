#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <utility>

#include "coilwright/simulation/step_response.hpp"
#include "coilwright/simulation/transient.hpp"
#include "simulation/frozen_contact.hpp"
#include "simulation/reference.hpp"
#include "simulation/stepper.hpp"

namespace coilwright::simulation {
namespace {

using actuator::Configuration;
using actuator::ContactChoice;

bool same_contact(const Model& model, const State& a, const State& b) {
  for (int j = 0; j < model.joints(); ++j) {
    const mechanics::FaceContact& contact = model.hinges()[static_cast<std::size_t>(j)].contact;
    if ((contact.torque(a.angles[j], a.rates[j]) > 0.0) != (contact.torque(b.angles[j], b.rates[j]) > 0.0))
      return false;
  }
  return true;
}

// One fixed step of the classical Runge-Kutta method, halved where faces meet or part until what is left of the kink is
// nothing. `watch(duration, state)` sees every piece.
template <typename Watch>
State through_contact(const Model& model, const actuator::CoilCurrents& currents, const State& state, double step,
                      const Watch& watch) {
  const State next = rk4_step(model, currents, state, step);
  if (step < 1e-10 || same_contact(model, state, next)) {
    watch(step, next);
    return next;
  }
  const State middle = through_contact(model, currents, state, 0.5 * step, watch);
  return through_contact(model, currents, middle, 0.5 * step, watch);
}

struct Case {
  const char* name;
  Configuration configuration;
  ContactChoice faces;
  double current;
  double gap;
  double bottom_layer;
  double magnet_length;
  double damping;  // over the prototype's: less time to follow by fixed steps
};

Model model_of(const Case& c) {
  actuator::Design design = actuator::paper_finger();
  design.layout = actuator::layout_of(c.configuration);
  design.choices.faces = c.faces;
  design.body.gap = c.gap;
  design.body.bottom_layer = c.bottom_layer;
  design.magnet.length = c.magnet_length;
  design.body.loss_time *= c.damping;
  return actuator::assemble_or_throw(design).model;
}

// The prototype's parts as C and D, thin and thick hinges, pressed and bouncing, pulled shut and opened.
constexpr Case cases[] = {
    {"C", Configuration::C, ContactChoice::hard_parts, 1.4, 0.9e-3, 2.5e-3, 6e-3, 1.0},
    {"C, walls", Configuration::C, ContactChoice::walls, 2.3, 0.7e-3, 3.3e-3, 4.1e-3, 2.0},
    {"C, walls, pulled shut", Configuration::C, ContactChoice::walls, -1.9, 1.1e-3, 1.9e-3, 5.2e-3, 1.0},
    {"C, pulled shut", Configuration::C, ContactChoice::hard_parts, -0.8, 0.8e-3, 2.9e-3, 6.7e-3, 1.0},
    {"D", Configuration::D, ContactChoice::hard_parts, 1.4, 0.9e-3, 2.5e-3, 6e-3, 4.0},
    {"D, walls", Configuration::D, ContactChoice::walls, 0.7, 1.2e-3, 2.1e-3, 5.5e-3, 4.0},
    {"D, walls, pulled shut", Configuration::D, ContactChoice::walls, -1.3, 0.9e-3, 2.6e-3, 4.8e-3, 1.0}};

// Against an integrator of nothing but fixed steps: 20 us are a tenth of a radian of what pressed faces ring by.
TEST(StiffContact, StepsOfCAndDAreThoseOfFixedSteps) {
  for (const Case& c : cases) {
    const Model model = model_of(c);
    const actuator::CoilCurrents currents = model.all_coils(c.current);
    const JointVector rest = rest_of(model);
    const auto step = step_response(model, currents, rest);
    ASSERT_TRUE(step && step->settling_time) << c.name;
    const double end = step->steady_angles.sum();
    const double change = end - rest.sum();
    double time = 0.0;
    double fastest = 0.0;
    double beyond = 0.0;
    double settling = 0.0;
    State state{.angles = rest, .rates = straight(model)};
    const double duration = 1.05 * *step->settling_time + 0.02;
    while (time < duration)
      state = through_contact(model, currents, state, 2e-5, [&](double taken, const State& at) {
        time += taken;
        fastest = std::max(fastest, std::abs(at.rates.sum()));
        const double progress = (at.angles.sum() - rest.sum()) / change;
        beyond = std::max(beyond, progress - 1.0);
        if (std::abs(progress - 1.0) > 0.02) settling = time;
      });
    std::printf("  %-22s peak %.1e settling %.1e (relative) overshoot %.1e\n", c.name, step->peak_speed / fastest - 1.0,
                *step->settling_time / settling - 1.0, step->overshoot - beyond);
    EXPECT_NEAR(step->peak_speed, fastest, 1e-5 * fastest) << c.name;
    EXPECT_NEAR(*step->settling_time, settling, 1e-4 * settling + 2e-5) << c.name;
    EXPECT_NEAR(step->overshoot, beyond, 2e-5) << c.name;
  }
}

// The reason for it: pressed faces that ring at a kilohertz hold an explicit method to steps of 0.3 ms for seconds.
TEST(StiffContact, StepsAsLongAsTheMotionAllows) {
  const Model model = model_of(cases[1]);
  const JointVector rest = rest_of(model);
  Stepper stepper(model, {.relative = 1e-5, .absolute = 1e-6, .internal = 1e-8});
  stepper.start(0.0, {.angles = rest, .rates = straight(model), .internal = {}},
                {.currents = model.all_coils(1.4), .applied = straight(model)});
  int steps = 0;
  for (; stepper.time() < 2.0 && steps < 20000; ++steps) stepper.step();
  EXPECT_LT(steps, 600);
}

TEST(StiffContact, HasTheSlopesThatItsMotionShows) {
  for (const Case& c : {cases[1], cases[5]}) {
    const Model model = model_of(c);
    const int n = model.joints();
    MotionVector values(2 * n);
    for (int j = 0; j < n; ++j) {
      values[j] = j == 1 ? -0.002 : 0.21 + 0.13 * j;
      values[n + j] = j == 1 ? -0.4 : 3.1 - 1.7 * j;
    }
    actuator::CoilCurrents currents(model.coils());
    for (int i = 0; i < model.coils(); ++i) currents[i] = 0.9 - 0.35 * i;
    const JointVector none = straight(model);
    const FrozenContact contact(model, currents, none, values);
    EXPECT_TRUE(contact.pushing(1));
    EXPECT_FALSE(contact.pushing(0));
    const mechanics::ChainSlopes slopes = contact.slopes(values, contact.derive(values));
    for (int i = 0; i < 2 * n; ++i) {
      constexpr double step = 1e-5;
      MotionVector ahead = values;
      MotionVector behind = values;
      ahead[i] += step;
      behind[i] -= step;
      const JointVector slope = (contact.derive(ahead) - contact.derive(behind)).tail(n) / (2.0 * step);
      const JointVector torques = slopes.by_acceleration * slope + (i < n ? JointVector(slopes.by_angle.col(i))
                                                                          : JointVector(slopes.by_rate.col(i - n)));
      // Central differences of torques of a tenth of a newton metre, through a stop of 75 N m/rad.
      EXPECT_LT(torques.lpNorm<Eigen::Infinity>(), 1e-6) << c.name << i;
    }
  }
}

// A joint that its coil throws onto its stop and holds there: what it has gained is what the coil gave less what hinge
// and faces took, through bounces and while it is pressed. Gauss's three points on each step's dense output: steps end
// where faces meet.
TEST(StiffContact, BalancesTheEnergyOfABouncingJoint) {
  const Model model = finger(Configuration::A).model;
  const actuator::CoilCurrents currents = model.all_coils(-1.3);
  const actuator::Hinge& hinge = model.hinges().front();
  const auto power = [&](const State& at) {
    JointVector magnetic = straight(model);
    model.magnetics().add_torques(model.chain(), at.angles, currents, magnetic);
    const double spring = hinge.contact.stiffness * std::max(0.0, hinge.contact.closing_angle - at.angles[0]);
    const double faces = hinge.contact.torque(at.angles[0], at.rates[0]) - spring;
    return (magnetic[0] - hinge.damping * at.rates[0] + faces) * at.rates[0];
  };
  const State start{.angles = JointVector::Constant(1, 0.35), .rates = straight(model), .internal = {}};
  Stepper stepper(model, {.relative = 1e-7, .absolute = 1e-9, .internal = 1e-9});
  stepper.start(0.0, start, {.currents = currents, .applied = straight(model)});
  double work = 0.0;
  double turnover = 0.0;
  int meetings = 0;
  while (stepper.time() < 0.3) {
    const double before = stepper.now().angles[0];
    stepper.step();
    const double length = stepper.time() - stepper.previous_time();
    for (const auto& [place, weight] :
         {std::pair(-std::sqrt(0.6), 5.0 / 18.0), std::pair(0.0, 8.0 / 18.0), std::pair(std::sqrt(0.6), 5.0 / 18.0)}) {
      const double part = weight * length * power(stepper.at(stepper.previous_time() + 0.5 * (1.0 + place) * length));
      work += part;
      turnover += std::abs(part);
    }
    const double closing = hinge.contact.closing_angle;
    if (before >= closing && stepper.now().angles[0] < closing) ++meetings;
  }
  EXPECT_GE(meetings, 2);
  EXPECT_LT(stepper.now().angles[0], hinge.contact.closing_angle);
  const double gained = energy_of(model, stepper.now()) - energy_of(model, start);
  std::printf("  %d meetings, off by %.1e of what was turned over\n", meetings, (gained - work) / turnover);
  // A meeting is taken to be at a step's end when it is in its last thousandth.
  EXPECT_NEAR(gained, work, 1e-5 * turnover);
}

TEST(StiffContact, SimulatesAtEverySampleWhateverTheirSpacing) {
  const Model model = model_of(cases[1]);
  const State start{.angles = rest_of(model), .rates = straight(model)};
  ModelInput sparse;
  sparse.times = {0.0, 0.133, 0.9};
  sparse.currents.assign(3, model.all_coils(1.1));
  const ModelInput dense = step_input(model, {.current = 1.1, .duration = 0.9, .interval = 1e-3});
  const std::vector<State> few = simulate(model, sparse, start);
  const std::vector<State> many = simulate(model, dense, start);
  EXPECT_LT((few[1].angles - many[133].angles).lpNorm<Eigen::Infinity>(), 1e-12);
  EXPECT_LT((few[2].angles - many.back().angles).lpNorm<Eigen::Infinity>(), 1e-12);
  const std::vector<State> exact = simulate(model, dense, start, {.relative = 1e-10});
  for (std::size_t i = 0; i < many.size(); i += 7)
    EXPECT_LT((many[i].angles - exact[i].angles).lpNorm<Eigen::Infinity>(), 1e-6) << dense.times[i];
}

}  // namespace
}  // namespace coilwright::simulation
