#include "settling_energy_criterion.hpp"

#include <Eigen/Cholesky>
#include <cmath>
#include <utility>

namespace coilwright::simulation {
namespace {

using mechanics::JointMatrix;
using mechanics::JointVector;

// Of the excursion's energy; what is left covers the change of stiffness over it. A smaller share costs time: the
// motion has to be followed until it has died down that far.
constexpr double energy_share = 0.64;

// Stiffness that a stop adds at least for excursions up to `excursion` away from it: the secant of the energy
// T x - T^2 / 2k of a joint that is pressed on with the torque T and leaves it.
double secant_stiffness(const mechanics::FaceContact& contact, double angle, double excursion) {
  const double pressure = contact.torque(angle, 0.0);
  if (pressure >= contact.stiffness * excursion) return contact.stiffness;
  return (2.0 * pressure - pressure * pressure / (contact.stiffness * excursion)) / excursion;
}

}  // namespace

SettlingEnergyCriterion::SettlingEnergyCriterion(const actuator::Model& model, const actuator::CoilCurrents& currents,
                                                 Spec spec)
    : model_(model), spec_(std::move(spec)), free_stiffness_(model.tangent_stiffness(spec_.equilibrium, currents)) {
  const JointMatrix tangent = free_stiffness_;
  JointMatrix held = free_stiffness_;
  for (int j = 0; j < model.joints(); ++j) {
    const mechanics::FaceContact& contact = model.hinges()[j].contact;
    const double angle = spec_.equilibrium[j];
    if (angle >= contact.closing_angle) continue;
    free_stiffness_(j, j) -= contact.stiffness;
    held(j, j) += secant_stiffness(contact, angle, spec_.excursion) - contact.stiffness;
  }
  Eigen::LLT<JointMatrix> factor(held);
  // Held by a stop alone, and hardly: no bound is known then, and that of small excursions has to serve.
  if (factor.info() != Eigen::Success) factor.compute(tangent);
  // The least energy that shows an excursion y of the bending angle is y^2 / (2 sum of the compliance).
  const JointVector ones = JointVector::Ones(model.joints());
  const double compliance = ones.dot(factor.solve(ones));
  energy_limit_ = energy_share * 0.5 * spec_.excursion * spec_.excursion / compliance;
}

// Energy in the stops above that of the equilibrium, less what the pressure there takes out of the linear term.
double SettlingEnergyCriterion::stop_energy(const JointVector& away) const {
  double energy = 0.0;
  for (int j = 0; j < model_.joints(); ++j) {
    const mechanics::FaceContact& contact = model_.hinges()[j].contact;
    const double angle = spec_.equilibrium[j];
    energy += contact.energy(angle + away[j]) - contact.energy(angle) + contact.torque(angle, 0.0) * away[j];
  }
  return energy;
}

bool SettlingEnergyCriterion::confines(const State& state) const {
  const JointVector away = state.angles - spec_.equilibrium;
  if (std::abs(away.sum()) > spec_.excursion) return false;
  const double potential = 0.5 * away.dot(free_stiffness_ * away) + stop_energy(away);
  return potential < energy_limit_ &&
         potential + model_.chain().kinetic_energy(state.angles, state.rates) < energy_limit_;
}

}  // namespace coilwright::simulation
