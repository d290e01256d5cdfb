#include "coilwright/systems/gripper/grip_answer.hpp"

#include "coilwright/actuator/cost.hpp"
#include "coilwright/actuator/heat.hpp"
#include "coilwright/systems/gripper/grip_task.hpp"
#include "coilwright/systems/gripper/heat_of_hold.hpp"
#include "coilwright/thermal/steady_state.hpp"

namespace coilwright::systems::gripper {
namespace {

// Of coils and magnets while they grip, degC.
constexpr double cold = 20.0;

// In both fingers, unless the caller or the file says otherwise: that of the paper's demonstrations, A.
constexpr double paper_current = 1.4;

}  // namespace

GripAnswer grip(const actuator::Design& design, const Mounting& mounting, const Object& object, const GraspTask& task,
                const actuator::Supply& supply, const GripSearch& search) {
  const Gripper gripper(design, mounting);
  GripAnswer out{
      .mounting = mounting, .object = object, .current = task.current, .grasp = grasp(gripper, object, task)};
  if (out.grasp.holds) out.tolerance = placement_tolerance(design, mounting, object, task);
  out.heat = heat_of_hold(design, gripper, out.grasp, {.current = task.current, .supply = supply});
  out.cost = actuator::gripper_cost(actuator::cost_of(design, gripper.assembly()).total(), mounting.fingers);
  out.burns_from = thermal::current_limits(actuator::heat_network(design, gripper.assembly(), out.grasp.left)).runaway;
  if (design.magnet.has_coercivity()) {
    const actuator::InnerFields fields(design, gripper.assembly());
    out.magnets_cold = fields.demagnetisation(std::vector<double>(design.layout.size(), cold), task.current);
    if (out.heat && out.heat->temperatures.size() > 0)
      out.magnets_held = fields.demagnetisation(
          {out.heat->temperatures.data(), static_cast<std::size_t>(out.heat->temperatures.size())}, task.current);
  }
  if (search.most_current > 0.0)
    out.least_current = {.most = search.most_current,
                         .found = least_current(gripper, object, task, search.most_current)};
  if (search.most_friction > 0.0)
    out.least_friction = {.most = search.most_friction,
                          .found = least_friction(gripper, object, task, search.most_friction)};
  return out;
}

GripAnswer grip(const actuator::Design& design, const GripperTask& task, const std::optional<double>& current,
                const std::optional<actuator::OperatingPoint>& point, double most_friction) {
  const bool is_of_file = !current && point;
  GripAnswer out = grip(design, task.mounting, task.object,
                        {.current = is_of_file ? point->current : current.value_or(paper_current),
                         .open_current = task.open_current,
                         .acceleration = task.acceleration},
                        point ? point->supply : actuator::Supply{},
                        {.most_current = task.most_current, .most_friction = most_friction});
  out.is_of_file = is_of_file;
  return out;
}

}  // namespace coilwright::systems::gripper
