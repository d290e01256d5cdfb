#include "systems/driven_phase.hpp"

#include <array>
#include <utility>

#include "coilwright/actuator/parts/coil_magnet_pairs.hpp"

namespace coilwright::systems {

using actuator::CoilCurrents;
using actuator::Model;
using simulation::State;

DrivenPhase::DrivenPhase(const Model& model, const drive::Path& path, const CoilLoop& loop)
    : path_(path),
      loop_(loop),
      answer_(loop.response * loop.entry),
      pairs_(coil_magnet_pairs(model.magnetics())),
      kind_(loop),
      model_(with_coils(model)) {}

Model DrivenPhase::with_coils(const Model& model) const {
  actuator::ModelSpec spec = model.nominal_spec();
  spec.effects.push_back({.kind = &kind_, .values = {}});
  return Model(std::move(spec));
}

double DrivenPhase::current(const State& state) const {
  return loop_.entry.dot(state.internal.head(coils()));
}

double DrivenPhase::forward(const State& state) const {
  const CoilCurrents dropped =
      loop_.resistances.cwiseProduct(CoilCurrents(state.internal.head(coils()))) +
      induced(pairs_, coils(), {.chain = model_.chain(), .angles = state.angles, .rates = state.rates});
  return loop_.voltage - loop_.resistance * current(state) - answer_.dot(dropped) / answer_.dot(loop_.entry);
}

State DrivenPhase::without_current(State state) const {
  state.internal.head(coils()) -= answer_ * (current(state) / loop_.entry.dot(answer_));
  return state;
}

State DrivenPhase::moved(const State& from, double begin, double end, const simulation::Accuracy& accuracy) const {
  const CoilCurrents none = CoilCurrents::Zero(coils());  // what would be commanded has no meaning here
  const simulation::ModelInput input{.times = {begin, end}, .currents = {none, none}};
  return simulate_at(model_, input, from, std::array{end}, accuracy).front();
}

}  // namespace coilwright::systems
