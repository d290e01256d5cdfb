#include "motion.hpp"

#include <cmath>
#include <utility>

#include "coilwright/simulation/blocked_grasp.hpp"
#include "coilwright/simulation/equilibrium.hpp"
#include "coilwright/simulation/step_response.hpp"

namespace coilwright::simulation {

using mechanics::JointVector;

actuator::Model held_at_rest(const actuator::Model& model, const JointVector& rest) {
  if (!model.has_slow_states()) return model;
  return model.with_slow_states_held(model.settled(rest, model.all_coils(0.0)));
}

std::variant<JointVector, NoPerformance> rest_pose(const actuator::Model& model) {
  const auto rest = find_equilibrium(model, model.all_coils(0.0), JointVector::Zero(model.joints()));
  if (!rest) return NoPerformance{"no stable rest pose: a joint folds without current"};
  return *rest;
}

std::variant<FreeMotion, NoPerformance> free_motion_of(const actuator::Model& model, double current,
                                                       const JointVector& rest) {
  const actuator::CoilCurrents on = model.all_coils(current);
  const auto step = step_response(model, on, rest);
  if (!step) return NoPerformance{"the step from rest does not settle: a joint folds, or it rings beyond 60 s"};
  return FreeMotion{.rest_angles = rest,
                    .steady_angles = step->steady_angles,
                    .peak_bending_speed = step->peak_speed,
                    .peak_speed_time = step->peak_speed_time,
                    .peak_angle = step->peak_angle,
                    .peak_joint_angle = step->peak_joint_angle,
                    .overshoot = step->overshoot,
                    .rise_time = step->rise_time,
                    .settling_time = step->settling_time,
                    .modes = modes(model, step->steady_angles, on)};
}

std::variant<Grasp, NoPerformance> grasp_of(const actuator::Model& model, double current,
                                            const actuator::GraspPoint& point) {
  const auto grasp = blocked_grasp(model, model.all_coils(current), point);
  const auto idle = blocked_grasp(model, model.all_coils(0.0), point);
  if (!grasp || !idle) return NoPerformance{"no equilibrium with the tip against a wall"};
  return Grasp{.grasp_force = grasp->force, .grasp_angles = grasp->angles, .contact_force_no_current = idle->force};
}

std::variant<MotionSummary, NoPerformance> motion_of(const actuator::Model& model, double current,
                                                     const actuator::GraspPoint& grasp_point) {
  if (!std::isfinite(current)) return NoPerformance{"the current is not finite"};
  const auto rest = rest_pose(model);
  if (const auto* reason = std::get_if<NoPerformance>(&rest)) return *reason;
  const actuator::Model held = held_at_rest(model, std::get<JointVector>(rest));
  auto motion = free_motion_of(held, current, std::get<JointVector>(rest));
  if (const auto* reason = std::get_if<NoPerformance>(&motion)) return *reason;
  auto grasp = grasp_of(held, current, grasp_point);
  if (const auto* reason = std::get_if<NoPerformance>(&grasp)) return *reason;
  return MotionSummary{std::get<FreeMotion>(std::move(motion)), std::get<Grasp>(std::move(grasp))};
}

}  // namespace coilwright::simulation
