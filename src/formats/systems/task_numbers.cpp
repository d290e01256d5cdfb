#include "coilwright/formats/systems/task_numbers.hpp"

namespace coilwright::formats {

using systems::CrawlTask;
using systems::gripper::GripperTask;
using systems::gripper::ObjectShape;
using text::Rule;

std::vector<BlockNumber<CrawlTask>> crawl_numbers() {
  using enum BlockNumber<CrawlTask>::Kind;
  return {
      block_number<CrawlTask>(
          "friction_forwards", up_to(10.0), [](auto& task) -> auto& { return task.parts.friction.forwards; }, required),
      block_number<CrawlTask>(
          "friction_backwards", up_to(10.0), [](auto& task) -> auto& { return task.parts.friction.backwards; },
          required),
      block_number<CrawlTask>(
          "frequency_Hz", Rule::between(0.1, 1000.0), [](auto& task) -> auto& { return task.parts.drive.frequency; }),
      block_number<CrawlTask>(
          "duty", text::positive.and_also(Rule::below(1.0)), [](auto& task) -> auto& { return task.parts.drive.duty; }),
      block_number<CrawlTask>(
          "cell_voltage_V", up_to(100.0), [](auto& task) -> auto& { return task.parts.cell.voltage; }),
      block_number<CrawlTask>(
          "cell_capacity_mAh", up_to(1e6), [](auto& task) -> auto& { return task.parts.cell.capacity; }),
      block_number<CrawlTask>(
          "cell_limit_A", up_to(1e3), [](auto& task) -> auto& { return task.parts.cell.current_limit; }),
      block_number<CrawlTask>(
          "lead_resistance_Ohm", Rule::between(0.0, 1e3),
          [](auto& task) -> auto& { return task.parts.drive.lead_resistance; }),
      block_number<CrawlTask>(
          "payload_mass_g", up_to(1e4), [](auto& task) -> auto& { return task.parts.payload.mass; }),
      block_number<CrawlTask>(
          "payload_length_mm", up_to(1e3), [](auto& task) -> auto& { return task.parts.payload.length; }),
      block_number<CrawlTask>(
          "step_ms", Rule::between(1e-3, 1.0), [](auto& task) -> auto& { return task.timing.step; }, of_computation),
      block_number<CrawlTask>(
          "settling_periods", Rule::between(0, 10000), [](auto& task) -> auto& { return task.timing.settling_periods; },
          whole_step),
      block_number<CrawlTask>(
          "periods", Rule::between(1, 10000), [](auto& task) -> auto& { return task.timing.periods; }, whole_step)};
}

std::vector<BlockNumber<GripperTask>> grip_numbers(const GripperTask& base) {
  using enum BlockNumber<GripperTask>::Kind;
  std::vector<BlockNumber<GripperTask>> out{
      block_number<GripperTask>(
          "mounting_angle_deg", Rule::between(-89.0, 89.0), [](auto& task) -> auto& { return task.mounting.angle; }),
      block_number<GripperTask>(
          "spacing_mm", up_to(1e3), [](auto& task) -> auto& { return task.mounting.spacing; }),
      block_number<GripperTask>(
          "width_mm", up_to(1e3), [](auto& task) -> auto& { return task.object.width; }, required),
      // Contacts are solved to a share of the fingers' impulses: what weighs less than a milligram is lost in that.
      block_number<GripperTask>(
          "mass_g", Rule::between(1e-3, 1e5), [](auto& task) -> auto& { return task.object.mass; }, required),
      block_number<GripperTask>(
          "friction", up_to(10.0), [](auto& task) -> auto& { return task.object.friction; }, required),
      block_number<GripperTask>(
          "centre_x_mm", base.mounting.fingers > 2 ? Rule::between(0.0, 0.0) : Rule::between(-1e3, 1e3),
          [](auto& task) -> auto& { return task.object.centre.x(); }),
      {.key = "centre_below_palm_mm",
       .rule = Rule::between(-1e3, 1e3),
       .get = [](const GripperTask& task) { return -task.object.centre.y(); },
       .set = [](GripperTask& task, double value) { task.object.centre.y() = -value; }},
      block_number<GripperTask>(
          "open_current_A", Rule::between(-100.0, 100.0), [](auto& task) -> auto& { return task.open_current; }),
      block_number<GripperTask>(
          "acceleration_m_s2", Rule::between(0.0, 1e3), [](auto& task) -> auto& { return task.acceleration; }),
      block_number<GripperTask>(
          "least_current_up_to_A", up_to(100.0), [](auto& task) -> auto& { return task.most_current; },
          of_computation)};
  if (base.object.has_flat_sides())
    out.push_back(block_number<GripperTask>(
        "height_mm", up_to(1e3), [](auto& task) -> auto& { return task.object.height; }, required));
  return out;
}

ObjectShape shape_named(std::string_view name) {
  for (const ObjectShape each : {ObjectShape::cylinder, ObjectShape::box, ObjectShape::upright_cylinder})
    if (name == name_of(each)) return each;
  return ObjectShape::sphere;
}

}  // namespace coilwright::formats
