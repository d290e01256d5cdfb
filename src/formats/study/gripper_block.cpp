#include "formats/study/system_block.hpp"

#include "coilwright/systems/gripper/quantities.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using systems::gripper::GripperTask;
using systems::gripper::ObjectShape;
using systems::gripper::Polarity;
using GripperNumber = BlockNumber<GripperTask>;

// As `grip` has options. A height belongs to what has flat sides alone, a place beside the axis to two fingers.
std::vector<GripperNumber> numbers_of(const GripperTask& base) {
  using enum GripperNumber::Kind;
  std::vector<GripperNumber> out{
      block_number<GripperTask>(
          "mounting_angle_deg", Rule::between(-89.0, 89.0), [](auto& task) -> auto& { return task.mounting.angle; }),
      block_number<GripperTask>(
          "spacing_mm", up_to(1e3), [](auto& task) -> auto& { return task.mounting.spacing; }),
      block_number<GripperTask>(
          "width_mm", up_to(1e3), [](auto& task) -> auto& { return task.object.width; }, required),
      block_number<GripperTask>(
          "mass_g", up_to(1e5), [](auto& task) -> auto& { return task.object.mass; }, required),
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

// What no number of the study changes.
void require_possible(ObjectReader& in, const GripperTask& task) {
  const int fingers = task.mounting.fingers;
  if (fingers > 2 && !task.object.is_round_about_the_axis())
    throw in.at("fingers").error("must be 2 unless shape is sphere or upright_cylinder");
  if (fingers % 2 == 1 && task.mounting.polarity == Polarity::opposite)
    throw in.at("fingers").error("must be even where polarity is opposite");
}

void require_no_states(const actuator::Design& design) {
  require_without(
      design, [](const actuator::Model& model) { return model.internal_states() > 0; },
      "effects that have states of their own");
}

}  // namespace

SystemBlock read_gripper_block(const Node& node) {
  return read_object(node, [](ObjectReader& in) {
    GripperTask task;
    task.object.shape = in.choice_or<ObjectShape>("shape", ObjectShape::sphere,
                                                  {{"sphere", ObjectShape::sphere},
                                                   {"cylinder", ObjectShape::cylinder},
                                                   {"box", ObjectShape::box},
                                                   {"upright_cylinder", ObjectShape::upright_cylinder}});
    task.mounting.fingers = in.integer_or("fingers", 2, Rule::between(2, systems::gripper::most_fingers));
    task.mounting.polarity = in.choice_or<Polarity>("polarity", Polarity::same,
                                                    {{"same", Polarity::same}, {"opposite", Polarity::opposite}});
    require_possible(in, task);
    const std::vector<GripperNumber> numbers = numbers_of(task);
    read_numbers<GripperTask>(in, numbers, task);
    return SystemBlock{.quantities = systems::gripper::gripper_quantities(task_by("gripper", numbers, task)),
                       .variables = variables_of<GripperTask>("gripper", numbers, task),
                       .require_suitable = require_no_states};
  });
}

}  // namespace coilwright::formats
