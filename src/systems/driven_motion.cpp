#include "coilwright/systems/driven_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <utility>

#include "coilwright/actuator/coil_bank.hpp"
#include "coilwright/simulation/initial_state.hpp"
#include "systems/check.hpp"
#include "systems/driven_coils.hpp"
#include "systems/driven_phase.hpp"
#include "systems/require_timing.hpp"

namespace coilwright::systems {
namespace {

using actuator::CoilCurrents;
using actuator::Model;
using simulation::State;

// Of the circuit's time constant: a change of a diode or the limit is looked for after each such time, and then found
// to 2^-40 of it.
constexpr double watched = 0.25;
constexpr int halvings = 40;

// A current that a diode has let cross zero, and one that it should not see, A.
constexpr double crossed = -1e-12;
constexpr double backwards = -1e-9;

class Follower {
 public:
  Follower(const Model& model, const MotionDrive& drive, const MotionTiming& timing, const State& start,
           const simulation::Accuracy& accuracy)
      : drive_(drive),
        timing_(timing),
        accuracy_(accuracy),
        on_(model, drive.driver.on, on_path(drive.bank, drive.driver.on, drive.actuators)),
        dead_(model, drive.driver.dead, on_path(drive.bank, drive.driver.dead, drive.actuators)),
        off_(model, drive.driver.off, on_path(drive.bank, drive.driver.off, drive.actuators)),
        chop_(model, drive.driver.chop, on_path(drive.bank, drive.driver.chop, drive.actuators)),
        open_(model, {}, opened(loop_of(drive.bank))),
        coils_(model.coils()),
        watch_(watched * reduce(drive.bank).circuit.time_constant()),
        state_{.angles = start.angles, .rates = start.rates, .internal = Eigen::VectorXd::Zero(states())} {
    state_.internal.tail(states() - own_states()) = start.internal;
  }

  std::vector<MotionSample> follow() {
    sample();
    const drive::PhaseLengths lengths = phase_lengths(drive_.driver, drive_.pulses);
    if (drive_.pulses.duty == 1.0) {
      pulse(timing_.duration);
      return std::move(samples_);
    }
    for (double period = 0.0; time_ < timing_.duration; period += 1.0) {
      double end = period / drive_.pulses.frequency;
      const auto until = [&](double length) { return std::min(end += length, timing_.duration); };
      pulse(until(lengths.on));
      along(current() < 0.0 ? off_ : dead_, until(lengths.dead_before_off));
      along(off_, until(lengths.off));
      along(current() < 0.0 ? on_ : dead_, std::min((period + 1.0) / drive_.pulses.frequency, timing_.duration));
    }
    return std::move(samples_);
  }

 private:
  using Changed = std::function<bool(const State&)>;

  [[nodiscard]] int own_states() const { return coils_ + DrivenCoils::integrals; }
  [[nodiscard]] int states() const { return on_.model().internal_states(); }
  [[nodiscard]] double current() const { return on_.current(state_); }

  // While the pulse is on, with the limit.
  void pulse(double end) {
    if (!drive_.driver.limit) return along(on_, end);
    const drive::CurrentLimit& limit = *drive_.driver.limit;
    const Changed trips = [&](const State& state) { return total(on_.current(state)) >= limit.trip; };
    while (time_ < end) {
      along(on_, std::min(end, time_ + limit.blanking));
      if (!trips(state_)) advance(on_, end, trips);
      if (time_ < end) along(chop_, std::min(end, time_ + limit.off_time));
    }
  }

  // Along a path to `end`, with its diodes.
  void along(const DrivenPhase& phase, double end) {
    const bool one_way = phase.path().one_way;
    while (time_ < end) {
      if (one_way && current() < backwards)
        throw std::runtime_error(fmt::format("the motion drives a current backwards into a diode at {:.6g} s", time_));
      const bool at_zero = one_way && current() <= 0.0;
      if (at_zero) state_ = phase.without_current(std::move(state_));
      if (at_zero && phase.forward(state_) <= 0.0)
        advance(open_, end, [&](const State& state) { return phase.forward(state) > 0.0; });
      else
        advance(phase, end,
                one_way ? Changed([&](const State& state) { return phase.current(state) < crossed; }) : Changed());
    }
  }

  // On one path to `end`, or to where `changed` first holds.
  void advance(const DrivenPhase& phase, double end, const Changed& changed) {
    while (time_ < end) {
      const double next = next_sample();
      const double piece = std::min({end, next, changed ? time_ + watch_ : end});
      State after = phase.moved(state_, time_, piece, accuracy_);
      const bool ends = changed && changed(after);
      double reached = piece;
      if (ends) {
        double before = time_;
        State good = state_;
        for (int i = 0; i < halvings; ++i) {
          const double middle = before + 0.5 * (reached - before);
          if (!(middle > before && middle < reached)) break;
          State there = phase.moved(good, before, middle, accuracy_);
          if (changed(there)) {
            reached = middle;
            after = std::move(there);
          } else {
            before = middle;
            good = std::move(there);
          }
        }
      }
      add_energies(phase.path(), after);
      state_ = std::move(after);
      time_ = reached;
      if (time_ >= next) sample();
      if (ends) return;
    }
  }

  [[nodiscard]] double total(double of_one) const {
    return drive_.bank.wiring == drive::BankWiring::series ? of_one : drive_.actuators * of_one;
  }

  void add_energies(const drive::Path& path, const State& after) {
    const auto grown = [&](DrivenCoils::Integral which) {
      return after.internal[coils_ + which] - state_.internal[coils_ + which];
    };
    const double charge = total(grown(DrivenCoils::charge));
    const double square = total(total(grown(DrivenCoils::square)));
    charge_ += charge;
    energies_.source += path.source * charge;
    energies_.diodes += path.diodes * charge;
    energies_.switches += path.resistance * square;
    energies_.supply += path.supply_resistance * square;
    energies_.coils += drive_.actuators * grown(DrivenCoils::heat);
    energies_.work += drive_.actuators * grown(DrivenCoils::work);
  }

  [[nodiscard]] double next_sample() const {
    const double next = static_cast<double>(samples_.size()) * timing_.interval;
    return next < timing_.duration - 1e-9 * timing_.interval ? next : timing_.duration;  // not twice by its roundings
  }

  void sample() {
    const CoilCurrents currents = state_.internal.head(coils_);
    MotionSample now{.time = time_,
                     .state = {.angles = state_.angles,
                               .rates = state_.rates,
                               .internal = state_.internal.tail(states() - own_states())},
                     .currents = currents,
                     .driver_current = total(current()),
                     .charge = charge_,
                     .energies = energies_};
    now.energies.field = 0.5 * drive_.actuators * currents.dot(drive_.bank.inductances * currents);
    samples_.push_back(std::move(now));
  }

  const MotionDrive& drive_;
  MotionTiming timing_;
  simulation::Accuracy accuracy_;
  DrivenPhase on_, dead_, off_, chop_, open_;
  int coils_;
  double watch_;
  double time_ = 0.0;
  State state_;
  double charge_ = 0.0;
  MotionEnergies energies_{};
  std::vector<MotionSample> samples_;
};

void check(const Model& model, const MotionDrive& drive, const MotionTiming& timing, const State& start) {
  require(drive.bank.resistances.size() == model.coils() && model.coils() > 0, "bank.resistances",
          fmt::format("one a coil, {} and at least one here", model.coils()),
          static_cast<double>(drive.bank.resistances.size()));
  require(drive.actuators >= 1, "actuators", ">= 1", drive.actuators);
  require(drive.pulses.frequency > 0.0, "frequency", "> 0", drive.pulses.frequency, "Hz");
  require(drive.pulses.duty >= 0.0 && drive.pulses.duty <= 1.0, "duty", "from 0 to 1", drive.pulses.duty);
  require_timing(timing);
  require(timing.duration * drive.pulses.frequency <= most_pulses, "duration",
          fmt::format("at most {:.6g} s, the time of {:.0f} pulses", most_pulses / drive.pulses.frequency, most_pulses),
          timing.duration, "s");
  require_samples(timing, most_pulses);
  require_no_effects_up_to(model, actuator::Stage::magnetics, "currents or magnetics");
  if (start.internal.size() != model.internal_states())
    throw std::invalid_argument(fmt::format("start: {} states of the effects are needed; got {}",
                                            model.internal_states(), start.internal.size()));
}

}  // namespace

std::vector<MotionSample> drive_motion(const Model& model, const MotionDrive& drive, const MotionTiming& timing,
                                       const State& start, const simulation::Accuracy& accuracy) {
  check(model, drive, timing, start);
  return Follower(model, drive, timing, start, accuracy).follow();
}

std::vector<MotionSample> drive_motion(const actuator::Design& design, const actuator::Assembly& assembly,
                                       const DriveQuestion& question, const DrivenActuator& answer,
                                       const MotionTiming& timing) {
  const Model& model = assembly.model;
  const std::optional<State> rest =
      simulation::state_at_rest(model, model.all_coils(0.0), mechanics::JointVector::Zero(model.joints()));
  if (!rest) throw std::invalid_argument("there is no stable pose without current to start from");
  const MotionDrive drive{.bank = coil_bank(design, assembly, question.wiring, answer.coil_temperatures),
                          .driver = answer.phases,
                          .pulses = {.frequency = question.frequency, .duty = answer.duty},
                          .actuators = question.actuators};
  return drive_motion(model, drive, timing, *rest);
}

MotionSummary summary_of(const std::vector<MotionSample>& motion) {
  const auto bending = [](const MotionSample& sample) { return Model::bending_angle(sample.state.angles); };
  const auto speed = [](const MotionSample& sample) { return std::abs(sample.state.rates.sum()); };
  const auto& widest = *std::ranges::max_element(motion, {}, bending);
  const auto& fastest = *std::ranges::max_element(motion, {}, speed);
  return {.duration = motion.back().time - motion.front().time,
          .start_bending = bending(motion.front()),
          .end_bending = bending(motion.back()),
          .most_bending = bending(widest),
          .most_bending_time = widest.time,
          .most_speed = speed(fastest),
          .most_speed_time = fastest.time,
          .energies = motion.back().energies};
}

}  // namespace coilwright::systems
