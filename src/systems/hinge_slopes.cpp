#include "systems/hinge_slopes.hpp"

namespace coilwright::systems {

HingeSlopes hinge_slopes(const actuator::Model& model, const mechanics::JointVector& angles,
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
