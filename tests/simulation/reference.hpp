#pragma once

#include <cmath>
#include <vector>

#include "actuator/paper_finger.hpp"
#include "coilwright/actuator/assemble.hpp"
#include "coilwright/simulation/equilibrium.hpp"
#include "coilwright/simulation/state.hpp"

namespace coilwright::simulation {

using actuator::Model;
using mechanics::JointVector;

/// A finger of prototype parts in one of the paper's configurations.
inline actuator::Assembly finger(actuator::Configuration configuration) {
  actuator::Design design = actuator::paper_finger();
  design.layout = actuator::layout_of(configuration);
  return actuator::assemble_or_throw(design);
}

/// The same model with other hinges.
template <typename Change>
Model with_hinges(const Model& model, Change&& change) {
  std::vector<actuator::Hinge> hinges = model.hinges();
  for (actuator::Hinge& hinge : hinges) change(hinge);
  return Model({.chain = model.chain(),
                .hinges = std::move(hinges),
                .magnetics = model.magnetics(),
                .coils = model.coils(),
                .tip = model.tip()});
}

inline JointVector straight(const Model& model) {
  return JointVector::Zero(model.joints());
}

inline JointVector rest_of(const Model& model) {
  return find_equilibrium(model, model.all_coils(0.0), straight(model)).value();
}

/// One step of the classical Runge-Kutta method of fixed step: nothing of the integrator under test. For a model whose
/// effects have no states of their own.
inline State rk4_step(const Model& model, const actuator::CoilCurrents& currents, const State& state, double step) {
  const JointVector none = straight(model);
  const auto slope = [&](const State& s) {
    State out{.angles = s.rates, .rates = none};
    model.derivative(s.angles, s.rates, {}, currents, none, out.rates, {});
    return out;
  };
  const auto moved = [&](const State& s, double by) {
    return State{.angles = state.angles + by * s.angles, .rates = state.rates + by * s.rates};
  };
  const State a = slope(state);
  const State b = slope(moved(a, 0.5 * step));
  const State c = slope(moved(b, 0.5 * step));
  const State d = slope(moved(c, step));
  return {.angles = state.angles + step / 6.0 * (a.angles + 2.0 * b.angles + 2.0 * c.angles + d.angles),
          .rates = state.rates + step / 6.0 * (a.rates + 2.0 * b.rates + 2.0 * c.rates + d.rates)};
}

/// Energy of gravity, springs, stops, magnets among themselves and motion, J; what coils do is work, not energy.
inline double energy_of(const Model& model, const State& state) {
  const mechanics::PlanarChain& chain = model.chain();
  double energy = chain.kinetic_energy(state.angles, state.rates) + chain.potential_energy(state.angles);
  for (int j = 0; j < model.joints(); ++j) {
    const actuator::Hinge& hinge = model.hinges()[static_cast<std::size_t>(j)];
    energy += 0.5 * hinge.stiffness * state.angles[j] * state.angles[j] + hinge.contact.energy(state.angles[j]);
  }
  for (const actuator::DistantPair& pair : model.magnetics().distant_pairs()) {
    if (pair.coil >= 0) continue;
    const double distance =
        (chain.position(pair.second, state.angles) - chain.position(pair.first, state.angles)).norm();
    energy += pair.sense * pair.axial_energy->value(distance);  // Orientation::ignored: no shape
  }
  return energy;
}

}  // namespace coilwright::simulation
