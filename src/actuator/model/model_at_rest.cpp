#include "coilwright/actuator/model/model.hpp"

// Model near a pose at rest: what pulls it away, and how stiff and damped it is there.

namespace coilwright::actuator {

using mechanics::JointMatrix;
using mechanics::JointVector;

JointVector Model::static_residual(const JointVector& angles, const CoilCurrents& currents,
                                   InitialHistory history) const {
  return torques(angles, JointVector::Zero(joints()), currents, history) - spec_.chain.gravity_torques(angles);
}

// Strengths do not depend on the pose, so only what the terms themselves add is left to differences.
void Model::add_term_stiffness(const JointVector& angles, const CoilCurrents& command, InitialHistory history,
                               JointMatrix& stiffness) const {
  constexpr double step = 1e-5;  // rad: truncation 1e-10 relative, as for distant pairs
  const JointVector still = JointVector::Zero(joints());
  JointVector shifted = angles;
  const EffectTerm::Kinematics motion{.chain = spec_.chain, .angles = shifted, .rates = still};
  const auto term_torques = [&] {
    const InternalStates states = settled(shifted, command, history);
    JointVector torque = JointVector::Zero(joints());
    add_term_torques(motion, strength(command, states.data(), nullptr), states.data(), nullptr, torque);
    return torque;
  };
  for (int j = 0; j < joints(); ++j) {
    shifted[j] = angles[j] + step;
    const JointVector ahead = term_torques();
    shifted[j] = angles[j] - step;
    const JointVector behind = term_torques();
    shifted[j] = angles[j];
    stiffness.col(j) -= (ahead - behind) / (2.0 * step);
  }
}

JointMatrix Model::tangent_stiffness(const JointVector& angles, const CoilCurrents& currents,
                                     InitialHistory history) const {
  JointMatrix stiffness = spec_.chain.gravity_stiffness(angles);
  for (int j = 0; j < joints(); ++j)
    stiffness(j, j) += spec_.hinges[j].stiffness + spec_.hinges[j].contact.tangent_stiffness(angles[j]);
  if (terms_.empty()) {
    spec_.magnetics.add_stiffness(spec_.chain, angles, currents, stiffness);
    return stiffness;
  }
  const InternalStates states = settled(angles, currents, history);
  spec_.magnetics.add_stiffness(spec_.chain, angles, strength(currents, states.data(), nullptr), stiffness);
  add_term_stiffness(angles, currents, history, stiffness);
  return stiffness;
}

JointVector Model::damping(const JointVector& angles) const {
  JointVector damping(joints());
  for (int j = 0; j < joints(); ++j) {
    const Hinge& hinge = spec_.hinges[j];
    damping[j] = hinge.damping + (angles[j] < hinge.contact.closing_angle ? hinge.contact.damping : 0.0);
  }
  return damping;
}

JointMatrix Model::damping(const JointVector& angles, const CoilCurrents& command) const {
  JointMatrix out = JointMatrix::Zero(joints(), joints());
  out.diagonal() = damping(angles);
  if (terms_.empty()) return out;
  const InternalStates states = settled(angles, command);
  const CoilCurrents seen = strength(command, states.data(), nullptr);
  const JointVector still = JointVector::Zero(joints());
  for (const Term& term : terms(Stage::magnetics, Stage::chain))
    term.effect->add_damping({.chain = spec_.chain, .angles = angles, .rates = still}, seen, out);
  return out;
}

}  // namespace coilwright::actuator
