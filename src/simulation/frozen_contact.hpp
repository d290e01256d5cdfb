#pragma once

#include <array>

#include "coilwright/actuator/model/model.hpp"
#include "rosenbrock_step.hpp"

namespace coilwright::simulation {

/// A model's equation of motion with each joint's faces held as they are at one instant: pushing, as a spring and
/// damper that would pull too, or not there. Smooth, so that a step of any length can be taken; it is the model's
/// motion as long as changed() says no. For models without effects that act (Model::has_terms).
class FrozenContact {
 public:
  /// Angles and rates `start` decide which faces push; `currents` (A) and `applied` (N m) are kept by reference.
  FrozenContact(const actuator::Model& model, const actuator::CoilCurrents& currents,
                const mechanics::JointVector& applied, const MotionVector& start);

  /// Slopes of angles and rates.
  [[nodiscard]] MotionVector derive(const MotionVector& values) const;
  /// What they change by, as RosenbrockStep takes it.
  [[nodiscard]] mechanics::ChainSlopes slopes(const MotionVector& values, const MotionVector& derived) const;
  /// Whether a joint's faces push at the start.
  [[nodiscard]] bool pushing(int joint) const { return pushing_[joint]; }
  /// Whether a joint's faces have begun or ceased to push.
  [[nodiscard]] bool changed(int joint, const MotionVector& values) const {
    return pushes(joint, values) != pushing_[joint];
  }

 private:
  [[nodiscard]] bool pushes(int joint, const MotionVector& values) const {
    return model_.hinges()[joint].contact.torque(values[joint], values[model_.joints() + joint]) > 0.0;
  }

  const actuator::Model& model_;
  const actuator::CoilCurrents& currents_;
  const mechanics::JointVector& applied_;
  std::array<bool, mechanics::max_joints> pushing_{};
};

}  // namespace coilwright::simulation
