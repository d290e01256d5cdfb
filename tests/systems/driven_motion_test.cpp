#include "coilwright/systems/driven_motion.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "coilwright/actuator/coil_bank.hpp"
#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "coilwright/drive/steady_current.hpp"
#include "error_text.hpp"
#include "simulation/reference.hpp"

namespace coilwright::systems {
namespace {

using actuator::Assembly;
using actuator::Model;
using drive::BankWiring;
using drive::Decay;
using mechanics::JointVector;
using simulation::State;

const Assembly& built_finger() {
  static const Assembly built = actuator::assemble_or_throw(actuator::paper_finger());
  return built;
}

drive::CoilBank bank(BankWiring wiring) {
  return coil_bank(actuator::paper_finger(), built_finger(), wiring, Eigen::Vector2d::Constant(20.0));
}

drive::Driver bridge(double voltage, Decay decay = Decay::slow) {
  return driver_of(drive::HBridge{.supply_voltage = voltage, .supply_resistance = 0.07, .decay = decay});
}

drive::Driver cell(double emf) {
  return driver_of(drive::CellSwitch{.emf = emf, .resistance = 0.1, .switch_resistance = 0.05, .diode_voltage = 0.1});
}

// Where a model hangs without current.
State rest(const Model& model) {
  return {.angles = simulation::rest_of(model), .rates = JointVector::Zero(model.joints())};
}

// Simpson's rule over samples that are equally far apart; an even number of intervals.
template <typename Power>
double integral(const std::vector<MotionSample>& motion, Power&& power) {
  double sum = 0.0;
  for (std::size_t i = 0; i + 2 < motion.size(); i += 2)
    sum += (motion[i + 1].time - motion[i].time) / 3.0 *
           (power(motion[i]) + 4.0 * power(motion[i + 1]) + power(motion[i + 2]));
  return sum;
}

// What meeting faces take, J: their damper's power, and their spring's where they part faster than it pushes. It jumps
// where faces meet, which is found between two samples on a straight line.
double lost_by_faces(const Model& model, const std::vector<MotionSample>& motion) {
  double sum = 0.0;
  for (int j = 0; j < model.joints(); ++j) {
    const mechanics::FaceContact& faces = model.hinges()[j].contact;
    const auto pressed = [&](const MotionSample& s) { return faces.closing_angle - s.state.angles[j]; };
    const auto power = [&](double penetration, double rate) {
      const double spring = faces.stiffness * penetration;
      return (spring - std::max(0.0, spring - faces.damping * rate)) * rate;
    };
    for (std::size_t i = 0; i + 1 < motion.size(); ++i) {
      const double before = pressed(motion[i]), after = pressed(motion[i + 1]);
      if (before <= 0.0 && after <= 0.0) continue;
      const double rate_before = motion[i].state.rates[j], rate_after = motion[i + 1].state.rates[j];
      const double met = before < 0.0 ? before / (before - after) : 0.0;
      const double parted = after < 0.0 ? before / (before - after) : 1.0;
      const auto at = [&](double share) {
        const double penetration = std::max(0.0, before + share * (after - before));
        return power(penetration, rate_before + share * (rate_after - rate_before));
      };
      sum += 0.5 * (parted - met) * (motion[i + 1].time - motion[i].time) * (at(met) + at(parted));
    }
  }
  return sum;
}

struct DrivenCase {
  const char* name;
  BankWiring wiring;
  drive::Driver driver;
  drive::Pulses pulses;
  int actuators;
};

const DrivenCase cases[] = {
    {"slow, parallel", BankWiring::parallel, bridge(6.0), {.frequency = 490.0, .duty = 0.6}, 1},
    {"slow, series of two fingers", BankWiring::series, bridge(24.0), {.frequency = 490.0, .duty = 0.7}, 2},
    {"fast, parallel of two fingers", BankWiring::parallel, bridge(9.0, Decay::fast), {490.0, 0.55}, 2},
    {"cell", BankWiring::parallel, cell(4.2), {.frequency = 10.0, .duty = 0.5}, 1},
};

TEST(DrivenMotion, KeepsItsEnergyBook) {
  // One coil is turned round, so that its joint closes and its faces meet.
  actuator::Design design = actuator::paper_finger();
  design.layout.back().polarity = -1;
  const Assembly closing = actuator::assemble_or_throw(design);
  for (const DrivenCase& c : cases) {
    for (const Assembly* assembly : {&built_finger(), &closing}) {
      SCOPED_TRACE(c.name);
      const Model& model = assembly->model;
      const MotionDrive drive{.bank = coil_bank(design, *assembly, c.wiring, Eigen::Vector2d(20.0, 45.0)),
                              .driver = c.driver,
                              .pulses = c.pulses,
                              .actuators = c.actuators};
      const std::vector<MotionSample> motion =
          drive_motion(model, drive, {.duration = 0.12, .interval = assembly == &built_finger() ? 1e-5 : 2e-6},
                       rest(model), {.relative = 1e-9});
      const MotionEnergies& e = motion.back().energies;
      EXPECT_NEAR((e.coils + e.switches + e.diodes + e.supply + e.work + e.field) / e.source, 1.0, 1e-8);
      const double stored = energy_of(model, motion.back().state) - energy_of(model, motion.front().state);
      const double lost = integral(motion,
                                   [&](const MotionSample& sample) {
                                     return model.hinges()[0].damping * sample.state.rates.squaredNorm();
                                   }) +
                          lost_by_faces(model, motion);
      // Simpson's rule where all is smooth; faces that meet bend the powers within an interval, which leaves 2e-4 at 10
      // us and a tenth of it at 2 us.
      EXPECT_NEAR(e.work / c.actuators, stored + lost, (assembly == &built_finger() ? 1e-7 : 5e-5) * (stored + lost));
    }
  }
}

TEST(DrivenMotion, HasTheClosedFormsCurrentInAStalledFinger) {
  // So heavy that nothing moves, and without gravity.
  std::vector<mechanics::Link> links(built_finger().model.chain().links().begin(),
                                     built_finger().model.chain().links().end());
  for (mechanics::Link& link : links) link.mass *= 1e10;
  actuator::ModelSpec spec = built_finger().model.nominal_spec();
  spec.chain = mechanics::PlanarChain(links, 0.0);
  const Model stalled(spec);
  const State start{.angles = JointVector::Constant(2, 0.3), .rates = JointVector::Zero(2)};
  drive::HBridge limited{.supply_voltage = 24.0, .decay = Decay::slow, .trip = 3.0};
  std::vector<DrivenCase> all(std::begin(cases), std::end(cases));
  all.push_back({"limit", BankWiring::parallel, driver_of(limited), {.frequency = 490.0, .duty = 1.0}, 1});
  for (const DrivenCase& c : all) {
    SCOPED_TRACE(c.name);
    const MotionDrive drive{.bank = bank(c.wiring), .driver = c.driver, .pulses = c.pulses, .actuators = c.actuators};
    // From the twentieth period on; the limit's own period is another, of which there are hundreds.
    const double period = 1.0 / c.pulses.frequency;
    const std::vector<MotionSample> motion =
        drive_motion(stalled, drive, {.duration = 30.0 * period, .interval = period}, start, {.relative = 1e-10});
    const MotionSample& from = motion[20];
    const MotionSample& to = motion[30];
    // The other actuators' coils, as drive_actuator() has them.
    const drive::ReducedBank one = reduce(drive.bank);
    const bool series = c.wiring == BankWiring::series;
    const double times = series ? c.actuators : 1.0 / c.actuators;
    const drive::SteadyCurrent steady =
        steady_current({.resistance = one.circuit.resistance * times, .inductance = one.circuit.inductance * times},
                       c.driver, c.pulses);
    const double tolerance = c.driver.limit ? 1e-3 : 1e-8;  // a cycle of the limit more or less in 20 ms
    const double time = 10.0 * period;
    EXPECT_NEAR((to.charge - from.charge) / time / steady.mean, 1.0, tolerance);
    EXPECT_NEAR((to.energies.coils - from.energies.coils) / time / steady.powers.coils, 1.0, tolerance);
    EXPECT_NEAR((to.energies.source - from.energies.source) / time / steady.powers.source, 1.0, tolerance);
    EXPECT_NEAR((to.energies.switches - from.energies.switches) / time, steady.powers.switches,
                tolerance * steady.powers.source);
    EXPECT_NEAR((to.energies.diodes - from.energies.diodes) / time, steady.powers.diodes,
                tolerance * steady.powers.source);
    EXPECT_NEAR((to.state.angles - start.angles).norm(), 0.0, 1e-6);
  }
}

// A voltage from time 0 on without driver or mutual inductance, R and L of a coil in `times` the coil's.
MotionDrive constant_voltage(double resistances, double inductances, double current) {
  drive::CoilBank coils = bank(BankWiring::parallel);
  coils.resistances *= resistances;
  const Eigen::VectorXd own = inductances * coils.inductances.diagonal();
  coils.inductances = own.asDiagonal();
  return {.bank = coils,
          .driver = {.on = {.source = current * coils.resistances[0]}},
          .pulses = {.frequency = 1.0, .duty = 1.0}};
}

std::vector<State> with_effects(std::vector<actuator::Effect> effects, double current, double duration) {
  actuator::ModelSpec spec = built_finger().model.nominal_spec();
  spec.effects = std::move(effects);
  const Model model(spec);
  State start = rest(built_finger().model);
  start.internal = model.settled(start.angles, model.all_coils(0.0));
  return simulation::simulate(
      model, simulation::step_input(model, {.current = current, .duration = duration, .interval = 1e-3}), start,
      {.relative = 1e-10});
}

double largest_difference(const std::vector<MotionSample>& motion, const std::vector<State>& states) {
  double largest = 0.0;
  for (std::size_t i = 0; i < motion.size(); ++i)
    largest = std::max(largest, (motion[i].state.angles - states[i].angles).lpNorm<Eigen::Infinity>());
  return largest;
}

const actuator::EffectKind* effect(const char* id) {
  return actuator::standard_effects().find(id);
}

TEST(DrivenMotion, IsACurrentThatLagsWhereVoltageAndResistanceAreLarge) {
  // A million times R, L and voltage: the same L / R and current, and nothing that motion could induce.
  const State start = rest(built_finger().model);
  const std::vector<MotionSample> motion =
      drive_motion(built_finger().model, constant_voltage(1e6, 1e6, 0.9), {.duration = 0.3, .interval = 1e-3}, start,
                   {.relative = 1e-10});
  const double lag = bank(BankWiring::parallel).inductances(0, 0) / bank(BankWiring::parallel).resistances[0];
  const std::vector<State> lagging = with_effects({{effect("coil_lag"), {lag}}}, 0.9, 0.3);
  ASSERT_EQ(motion.size(), lagging.size());
  EXPECT_LT(largest_difference(motion, lagging), 1e-7);
  EXPECT_GT(largest_difference(motion, with_effects({}, 0.9, 0.3)), 1e-4);
}

TEST(DrivenMotion, TendsToTheEffectBackEmfAsTheInductanceVanishes) {
  // The effect has the induced current at once: what is left is of first order in L / R.
  const State start = rest(built_finger().model);
  const double resistance = bank(BankWiring::parallel).resistances[0];
  const double lag = bank(BankWiring::parallel).inductances(0, 0) / resistance;
  std::vector<double> differences;
  for (const double share : {0.4, 0.2, 0.1}) {
    const std::vector<MotionSample> motion =
        drive_motion(built_finger().model, constant_voltage(1.0, share, 0.9), {.duration = 0.3, .interval = 1e-3},
                     start, {.relative = 1e-10});
    differences.push_back(largest_difference(
        motion,
        with_effects({{effect("back_emf"), {1.0 / resistance}}, {effect("coil_lag"), {share * lag}}}, 0.9, 0.3)));
  }
  EXPECT_NEAR(differences[0] / differences[1], 2.0, 0.05);
  EXPECT_NEAR(differences[1] / differences[2], 2.0, 0.05);
  // A tenth of L / R of 0.3 ms, at 10 rad/s, of the sixth of the current that motion takes.
  EXPECT_LT(differences[2], 1e-4);
}

// The whole problem again: currents and chain in one vector, Runge and Kutta's classical method in small steps of its
// own, torque per ampere from differences of the model's torques, and the bridge as switches and diodes in which a
// current that motion has turned round finds the other diodes.
class Bench {
 public:
  Bench(const Model& model, const drive::HBridge& bridge, const drive::CoilBank& coils)
      : model_(model), bridge_(bridge), inverse_(coils.inductances.inverse()), coils_(coils), state_(6) {
    state_ << simulation::rest_of(model), Eigen::Vector4d::Zero();
  }

  Eigen::VectorXd run(const drive::Pulses& pulses, int periods, double step) {
    const double period = 1.0 / pulses.frequency, dead = bridge_.dead_time, on = pulses.duty * period - dead;
    for (int i = 0; i < periods; ++i) {
      hold(on, step,
           [&](double) { return std::pair(bridge_.supply_voltage, bridge_.high_resistance + bridge_.low_resistance); });
      hold(dead, step, [&](double current) { return diodes(current); });
      hold(period - on - 2.0 * dead, step, [&](double) { return std::pair(0.0, 2.0 * bridge_.low_resistance); });
      hold(dead, step, [&](double current) { return diodes(current); });
    }
    return state_;
  }

 private:
  std::pair<double, double> diodes(double current) const {
    if (current >= 0.0) return {-bridge_.diode_voltage, bridge_.low_resistance};
    return {bridge_.supply_voltage + bridge_.diode_voltage, bridge_.low_resistance};
  }

  template <typename Path>
  Eigen::VectorXd slope(const Eigen::VectorXd& x, const Path& path) const {
    const JointVector angles = x.head(2), rates = x.segment(2, 2);
    const actuator::CoilCurrents currents = x.tail(2);
    const auto [voltage, resistance] = path(currents.sum());
    JointVector accelerations(2);
    model_.derivative(angles, rates, {}, currents, JointVector::Zero(2), accelerations, {});
    Eigen::Vector2d across = Eigen::Vector2d::Constant(voltage - resistance * currents.sum());
    for (int c = 0; c < 2; ++c) {
      actuator::CoilCurrents more = currents;
      more[c] += 1.0;
      across[c] -= coils_.resistances[c] * currents[c] +
                   (model_.magnetic_torques(angles, more) - model_.magnetic_torques(angles, currents)).dot(rates);
    }
    Eigen::VectorXd out(6);
    out << rates, accelerations, inverse_ * across;
    return out;
  }

  template <typename Path>
  void hold(double time, double step, const Path& path) {
    const int steps = static_cast<int>(std::ceil(time / step));
    const double h = time / steps;
    for (int i = 0; i < steps; ++i) {
      const Eigen::VectorXd a = slope(state_, path), b = slope(state_ + 0.5 * h * a, path),
                            c = slope(state_ + 0.5 * h * b, path), d = slope(state_ + h * c, path);
      state_ += h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
    }
  }

  const Model& model_;
  drive::HBridge bridge_;
  Eigen::Matrix2d inverse_;
  drive::CoilBank coils_;
  Eigen::VectorXd state_;
};

TEST(DrivenMotion, AgreesWithAnIntegratorOfItsOwnSteps) {
  const drive::HBridge bridge{.supply_voltage = 6.0};
  const drive::Pulses pulses{.frequency = 490.0, .duty = 0.5};
  const drive::CoilBank coils = bank(BankWiring::parallel);
  const State start = rest(built_finger().model);
  const auto followed = [&](double relative) {
    return drive_motion(built_finger().model, {.bank = coils, .driver = driver_of(bridge), .pulses = pulses},
                        {.duration = 40.0 / 490.0, .interval = 40.0 / 490.0}, start, {.relative = relative})
        .back();
  };
  const MotionSample motion = followed(1e-7);
  Bench bench(built_finger().model, bridge, coils);
  const Eigen::VectorXd other = bench.run(pulses, 40, 5e-6);
  // 1e-7 a step over 40 periods, with a swing of a radian and 10 rad/s.
  EXPECT_NEAR((motion.state.angles - JointVector(other.head(2))).norm(), 0.0, 1e-6);
  EXPECT_NEAR((motion.state.rates - JointVector(other.segment(2, 2))).norm(), 0.0, 1e-4);
  EXPECT_NEAR((motion.currents - actuator::CoilCurrents(other.tail(2))).norm(), 0.0, 1e-5);
  const MotionSample finer = followed(1e-9);
  EXPECT_NEAR((motion.state.angles - finer.state.angles).norm(), 0.0, 1e-6);
  EXPECT_NEAR((motion.currents - finer.currents).norm(), 0.0, 1e-6);
}

TEST(DrivenMotion, IsLessBrakedByACurrentSourceThanByAVoltage) {
  // What the closed circuit takes from the swing is what drive_actuator() calls motional damping.
  const State start = rest(built_finger().model);
  const std::vector<MotionSample> motion =
      drive_motion(built_finger().model, constant_voltage(1.0, 1.0, 0.9), {.duration = 0.3, .interval = 1e-3}, start);
  const std::vector<State> imposed = with_effects({}, 0.9, 0.3);
  double fastest = 0.0, imposed_fastest = 0.0;
  for (std::size_t i = 0; i < motion.size(); ++i) {
    fastest = std::max(fastest, motion[i].state.rates.sum());
    imposed_fastest = std::max(imposed_fastest, imposed[i].rates.sum());
  }
  EXPECT_LT(fastest, imposed_fastest);
}

TEST(DrivenMotion, RejectsWhatItCannotFollow) {
  const State start = rest(built_finger().model);
  const MotionDrive drive{.bank = bank(BankWiring::parallel), .driver = bridge(6.0), .pulses = {490.0, 0.5}};
  const auto text = [&](const Model& model, const MotionDrive& by, const MotionTiming& timing) {
    return error_text([&] { (void)drive_motion(model, by, timing, start); });
  };
  EXPECT_EQ(text(built_finger().model, drive, {.duration = 0.0, .interval = 1e-3}), "duration must be > 0; got 0 s");
  EXPECT_EQ(text(built_finger().model, drive, {.duration = 0.1, .interval = 0.2}),
            "interval must be > 0 and at most the duration, 0.1 s; got 0.2 s");
  EXPECT_EQ(text(built_finger().model, drive, {.duration = 300.0, .interval = 0.1}),
            "duration must be at most 204.082 s, the time of 100000 pulses; got 300 s");
  EXPECT_EQ(text(built_finger().model, drive, {.duration = 1.0, .interval = 1e-6}),
            "interval must be at least 1e-05 s, for 100000 samples; got 1e-06 s");
  actuator::ModelSpec spec = built_finger().model.nominal_spec();
  spec.effects = {{effect("back_emf"), {0.1}}};
  EXPECT_EQ(text(Model(spec), drive, {.duration = 0.1, .interval = 1e-3}),
            "effect back_emf: acts on currents or magnetics, which follow from the driver here");
  MotionDrive one = drive;
  one.bank.resistances = Eigen::VectorXd::Ones(1);
  EXPECT_EQ(text(built_finger().model, one, {.duration = 0.1, .interval = 1e-3}),
            "bank.resistances must be one a coil, 2 and at least one here; got 1");
}

}  // namespace
}  // namespace coilwright::systems
