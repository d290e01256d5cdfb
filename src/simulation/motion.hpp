#pragma once

#include <optional>
#include <variant>

#include "coilwright/simulation/performance.hpp"

namespace coilwright::simulation {

/// `model` as it hangs at rest without current: its slow effects held there for good.
[[nodiscard]] actuator::Model held_at_rest(const actuator::Model& model, const mechanics::JointVector& rest);

/// Where it hangs without current, rad; or why nowhere.
[[nodiscard]] std::variant<mechanics::JointVector, NoPerformance> rest_pose(const actuator::Model& model);

/// A step of the current (A) from `rest`, where `model` hangs; slow effects are held.
[[nodiscard]] std::variant<FreeMotion, NoPerformance> free_motion_of(const actuator::Model& model, double current,
                                                                     const mechanics::JointVector& rest);

/// Against the wall of `point` under the current (A) and without.
[[nodiscard]] std::variant<Grasp, NoPerformance> grasp_of(const actuator::Model& model, double current,
                                                          const actuator::GraspPoint& point);

}  // namespace coilwright::simulation
