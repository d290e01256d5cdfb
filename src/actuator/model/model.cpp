#include "coilwright/actuator/model/model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>

#include "actuator/model/effect_row.hpp"
#include "actuator/model/move_with_chain.hpp"
#include "actuator/model/spec_checks.hpp"

namespace coilwright::actuator {

using mechanics::JointVector;

Model::Model(Spec spec) : spec_(std::move(spec)) {
  require_consistent(spec_);
  if (spec_.effects.empty() && !spec_.torque_correction) return;
  const std::vector<Effect> row = effect_row(spec_);
  if (!row.empty()) nominal_ = std::make_shared<const Spec>(spec_);
  for (const Effect& effect : row) {
    if (std::shared_ptr<const EffectTerm> term = effect.kind->build(effect.values, spec_))
      terms_.push_back({.effect = std::move(term), .stage = effect.kind->stage()});
  }
  require_consistent(spec_);
  if (spec_.torque_correction) {
    const auto after_chain = std::ranges::upper_bound(terms_, Stage::chain, {}, &Term::stage);
    terms_.insert(after_chain, Term{.effect = correction_term(*spec_.torque_correction, spec_), .stage = Stage::chain});
  }
  for (std::size_t stage = 0; stage < stage_begin_.size(); ++stage)
    stage_begin_[stage] = static_cast<std::size_t>(
        std::ranges::count_if(terms_, [&](const Term& term) { return static_cast<std::size_t>(term.stage) < stage; }));
  number_states();
}

void Model::number_states() {
  internal_states_ = 0;
  drive_states_ = 0;
  camera_states_ = 0;
  camera_filters_ = false;
  holds_joints_ = false;
  bodies_ = 0;
  for (Term& term : terms_) {
    if (term.held) continue;
    term.first = internal_states_;
    internal_states_ += term.effect->states();
    bodies_ += term.effect->bodies();
    if (term.stage == Stage::drive) drive_states_ = internal_states_;
    if (term.stage == Stage::camera) camera_states_ += term.effect->states();
    holds_joints_ = holds_joints_ || term.effect->holds_joints();
    camera_filters_ = camera_filters_ || (term.stage == Stage::camera && term.effect->shows());
  }
  if (bodies_ > max_bodies)
    throw std::invalid_argument(
        fmt::format("effects: at most {} bodies of their own together; got {}", max_bodies, bodies_));
  if (internal_states_ > max_internal_states)
    throw std::invalid_argument(
        fmt::format("effects: at most {} states of their own together; got {}", max_internal_states, internal_states_));
}

bool Model::is_of_a_body(int internal_state) const {
  return std::ranges::any_of(terms_, [internal_state](const Term& term) {
    const int place = internal_state - term.first;
    return !term.held && place >= 0 && place < 2 * term.effect->bodies();
  });
}

void Model::set_friction(const JointVector& shares, std::span<double> internal) const {
  for (const Term& term : terms_)
    if (!term.held && term.effect->holds_joints()) std::copy_n(shares.data(), joints(), internal.data() + term.first);
}

double Model::drive_lag() const noexcept {
  for (const Term& term : terms(Stage::drive, Stage::drive))
    if (!term.held && drive_states_ > 0 && term.effect->states() == drive_states_) return term.effect->lag();
  return 0.0;
}

std::span<const Model::Term> Model::terms(Stage first, Stage last) const {
  const std::size_t begin = stage_begin_[static_cast<std::size_t>(first)];
  return std::span(terms_).subspan(begin, stage_begin_[static_cast<std::size_t>(last) + 1] - begin);
}

EffectTerm::InternalStateView Model::own(const Term& term, const double* states, double* slopes) const {
  if (term.held) return {.states = held_.data() + term.first};
  return {.states = states + term.first, .slopes = slopes == nullptr ? nullptr : slopes + term.first};
}

void Model::settle(const Term& term, const EffectTerm::Kinematics& motion, const CoilCurrents& entering,
                   InitialHistory history, double* states) const {
  if (term.held) return;
  if (history == InitialHistory::recorded_run)
    term.effect->begin(motion, entering, states + term.first);
  else
    term.effect->settle(motion, entering, states + term.first);
}

CoilCurrents Model::settle_drive(const EffectTerm::Kinematics& motion, CoilCurrents currents, InitialHistory history,
                                 double* states) const {
  for (const Term& term : terms(Stage::drive, Stage::drive)) {
    settle(term, motion, currents, history, states);
    term.effect->drive(own(term, states, nullptr), currents);
  }
  return currents;
}

InternalStates Model::settled(const JointVector& angles, const CoilCurrents& command, InitialHistory history) const {
  InternalStates states = InternalStates::Zero(internal_states_);
  if (terms_.empty()) return states;
  const JointVector still = JointVector::Zero(joints());
  const EffectTerm::Kinematics motion{.chain = spec_.chain, .angles = angles, .rates = still};
  const CoilCurrents currents = settle_drive(motion, command, history, states.data());
  CoilCurrents strength = currents;
  for (const Term& term : terms(Stage::magnetics, Stage::magnetics)) {
    settle(term, motion, currents, history, states.data());
    term.effect->magnetize(own(term, states.data(), nullptr), currents, strength);
  }
  for (const Term& term : terms(Stage::hinge, Stage::camera)) settle(term, motion, strength, history, states.data());
  return states;
}

InternalStates Model::settled_drive(const CoilCurrents& command) const {
  InternalStates states = InternalStates::Zero(drive_states_);
  const JointVector still = JointVector::Zero(joints());
  settle_drive({.chain = spec_.chain, .angles = still, .rates = still}, command, InitialHistory::long_hold,
               states.data());
  return states;
}

CoilCurrents Model::currents_under(const CoilCurrents& voltages) const {
  if (!spec_.coil_resistance)
    throw std::invalid_argument("a voltage needs the resistance of a coil, which is not known");
  return voltages / *spec_.coil_resistance;
}

CoilCurrents Model::strength(const JointVector& angles, const CoilCurrents& command) const {
  return strength(command, settled(angles, command).data(), nullptr);
}

bool Model::has_slow_states() const noexcept {
  return std::ranges::any_of(
      terms_, [](const Term& term) { return !term.held && term.effect->states() > 0 && term.effect->slow(); });
}

Model Model::with_slow_states_held(const InternalStates& internal) const {
  Model out = *this;
  for (Term& term : out.terms_) {
    const int count = term.effect->states();
    if (term.held || count == 0 || !term.effect->slow()) continue;
    const auto begin = internal.data() + term.first;
    term.held = true;
    term.first = static_cast<int>(out.held_.size());
    out.held_.insert(out.held_.end(), begin, begin + count);
  }
  out.number_states();
  return out;
}

Model Model::with_magnet_strengths(std::span<const double> strengths) const {
  Spec spec = nominal_spec();
  spec.magnetics = spec.magnetics.with_magnet_strengths(strengths);
  return Model(std::move(spec));
}

CoilCurrents Model::strength(const CoilCurrents& command, const double* states, double* slopes) const {
  CoilCurrents currents = command;
  for (const Term& term : terms(Stage::drive, Stage::drive)) term.effect->drive(own(term, states, slopes), currents);
  const std::span<const Term> magnetics = terms(Stage::magnetics, Stage::magnetics);
  if (magnetics.empty()) return currents;
  CoilCurrents strength = currents;
  for (const Term& term : magnetics) term.effect->magnetize(own(term, states, slopes), currents, strength);
  return strength;
}

void Model::own_hinge_torques(const JointVector& angles, const JointVector& rates, JointVector& torques) const {
  for (int j = 0; j < joints(); ++j) {
    const Hinge& hinge = spec_.hinges[j];
    torques[j] = hinge.torque_offset - hinge.stiffness * angles[j] - hinge.damping * rates[j] +
                 hinge.contact.torque(angles[j], rates[j]);
  }
}

void Model::stage_torques(const JointVector& angles, const JointVector& rates, const CoilCurrents& strength,
                          JointVector& torques) const {
  own_hinge_torques(angles, rates, torques);
  spec_.magnetics.add_torques(spec_.chain, angles, strength, torques);
}

void Model::add_term_torques(const EffectTerm::Kinematics& motion, const CoilCurrents& strength, const double* states,
                             double* slopes, JointVector& torques) const {
  for (const Term& term : terms(Stage::magnetics, Stage::chain))
    term.effect->add_torques(motion, strength, own(term, states, slopes), torques);
}

JointVector Model::torques(const JointVector& angles, const JointVector& rates, const CoilCurrents& currents,
                           InitialHistory history) const {
  JointVector torque(joints());
  if (terms_.empty()) {
    stage_torques(angles, rates, currents, torque);
    return torque;
  }
  const InternalStates states = settled(angles, currents, history);
  const CoilCurrents seen = strength(currents, states.data(), nullptr);
  stage_torques(angles, rates, seen, torque);
  add_term_torques({.chain = spec_.chain, .angles = angles, .rates = rates}, seen, states.data(), nullptr, torque);
  return torque;
}

JointVector Model::magnetic_torques(const JointVector& angles, const CoilCurrents& command) const {
  const JointVector still = JointVector::Zero(joints());
  const InternalStates states = settled(angles, command);
  const CoilCurrents seen = strength(command, states.data(), nullptr);
  JointVector torque = JointVector::Zero(joints());
  spec_.magnetics.add_torques(spec_.chain, angles, seen, torque);
  for (const Term& term : terms(Stage::magnetics, Stage::magnetics))
    term.effect->add_torques({.chain = spec_.chain, .angles = angles, .rates = still}, seen,
                             own(term, states.data(), nullptr), torque);
  return torque;
}

JointVector Model::hinge_torques(const JointVector& angles) const {
  const JointVector still = JointVector::Zero(joints());
  const CoilCurrents off = all_coils(0.0);
  const InternalStates states = settled(angles, off);
  JointVector torque(joints());
  own_hinge_torques(angles, still, torque);
  for (const Term& term : terms(Stage::hinge, Stage::hinge))
    term.effect->add_torques({.chain = spec_.chain, .angles = angles, .rates = still}, off,
                             own(term, states.data(), nullptr), torque);
  return torque;
}

void Model::derivative(const JointVector& angles, const JointVector& rates, std::span<const double> internal,
                       const CoilCurrents& command, const JointVector& applied, JointVector& accelerations,
                       std::span<double> internal_slopes, std::span<const int> held) const {
  JointVector torque(joints());
  if (terms_.empty()) {
    stage_torques(angles, rates, command, torque);
    accelerations.noalias() = spec_.chain.accelerations(angles, rates, torque + applied);
    return;
  }
  const EffectTerm::Kinematics motion{.chain = spec_.chain, .angles = angles, .rates = rates, .applied = &applied};
  const CoilCurrents seen = strength(command, internal.data(), internal_slopes.data());
  stage_torques(angles, rates, seen, torque);
  add_term_torques(motion, seen, internal.data(), internal_slopes.data(), torque);
  accelerations.noalias() = spec_.chain.accelerations(angles, rates, torque + applied);
  if (bodies_ > 0 || !held.empty()) {
    mechanics::JointMatrix mass = spec_.chain.mass_matrix(angles);
    if (!held.empty()) hold_at_rest(held, mass, accelerations);
    if (bodies_ > 0)
      accelerate_bodies(motion, seen, internal.data(), internal_slopes.data(), held, mass, accelerations);
  }
  if (camera_states_ > 0) (void)shown(angles, rates, internal.data(), internal_slopes.data());
}

void Model::accelerate_bodies(const EffectTerm::Kinematics& motion, const CoilCurrents& strength, const double* states,
                              double* slopes, std::span<const int> held, const mechanics::JointMatrix& mass,
                              JointVector& accelerations) const {
  std::array<EffectTerm::Body, max_bodies> places;
  const std::span bodies = std::span(places).first(static_cast<std::size_t>(bodies_));
  for (EffectTerm::Body& body : bodies) body.coupling = JointVector::Zero(joints());
  std::size_t first = 0;
  for (const Term& term : terms_) {
    const int count = term.held ? 0 : term.effect->bodies();
    if (count == 0) continue;
    term.effect->describe_bodies(motion, strength, states + term.first, &bodies[first]);
    first += static_cast<std::size_t>(count);
  }
  for (EffectTerm::Body& body : bodies)
    for (const int joint : held) body.coupling[joint] = 0.0;
  std::array<double, max_bodies> moved;
  move_with_chain(mass, bodies, accelerations, std::span(moved).first(bodies.size()));
  std::size_t at = 0;
  for (const Term& term : terms_) {
    const int count = term.held ? 0 : term.effect->bodies();
    for (int b = 0; b < count; ++b) {
      slopes[term.first + b] = states[term.first + count + b];
      slopes[term.first + count + b] = moved[at++];
    }
  }
}

ShownMotion Model::shown(const JointVector& angles, const JointVector& rates, const double* states,
                         double* slopes) const {
  ShownMotion out{.angles = angles, .rates = rates};
  for (const Term& term : terms(Stage::camera, Stage::camera))
    term.effect->show(own(term, states, slopes), out.angles, out.rates);
  return out;
}

ShownMotion Model::shown(const JointVector& angles, const JointVector& rates, std::span<const double> internal) const {
  return shown(angles, rates, internal.data(), nullptr);
}

mechanics::ChainSlopes Model::slopes_without_contact(const JointVector& angles, const JointVector& rates,
                                                     const JointVector& accelerations,
                                                     const CoilCurrents& currents) const {
  assert(terms_.empty());
  mechanics::ChainSlopes slopes = spec_.chain.slopes(angles, rates, accelerations);
  for (int j = 0; j < joints(); ++j) {
    slopes.by_rate(j, j) += spec_.hinges[j].damping;
    slopes.by_angle(j, j) += spec_.hinges[j].stiffness;
  }
  spec_.magnetics.add_stiffness(spec_.chain, angles, currents, slopes.by_angle);
  return slopes;
}

double Model::observed(double angle) const {
  for (const Term& term : terms(Stage::camera, Stage::camera)) angle = term.effect->observed(angle);
  return angle;
}

double Model::delay() const {
  double sum = 0.0;
  for (const Term& term : terms(Stage::camera, Stage::camera)) sum += term.effect->delay();
  return sum;
}

}  // namespace coilwright::actuator
