#pragma once

#include "coilwright/actuator/model/model.hpp"

namespace coilwright::systems {

/// How the torques of all hinges fall with angle and rate at a pose: with those of their faces where they are pressed.
struct HingeSlopes {
  mechanics::JointVector stiffness;  ///< N m/rad
  mechanics::JointVector damping;    ///< N m s/rad

  /// What mechanics::MiddleOfStep adds to the mass of each joint so that a step of `duration`, s, takes them
  /// implicitly, kg m^2. Faces are so stiff that steps of 0.2 ms rattle on them otherwise.
  [[nodiscard]] mechanics::JointVector implicit_inertia(double duration) const {
    return 0.5 * duration * damping + 0.25 * duration * duration * stiffness;
  }
};

/// At these angles, rad, and rates, rad/s.
[[nodiscard]] inline HingeSlopes hinge_slopes(const actuator::Model& model, const mechanics::JointVector& angles,
                                              const mechanics::JointVector& rates) {
  HingeSlopes out{.stiffness = mechanics::JointVector(model.joints()),
                  .damping = mechanics::JointVector(model.joints())};
  for (int j = 0; j < model.joints(); ++j) {
    const actuator::Hinge& hinge = model.hinges()[j];
    const bool pressed = hinge.contact.torque(angles[j], rates[j]) > 0.0;
    out.stiffness[j] = hinge.stiffness + (pressed ? hinge.contact.stiffness : 0.0);
    out.damping[j] = hinge.damping + (pressed ? hinge.contact.damping : 0.0);
  }
  return out;
}

}  // namespace coilwright::systems
