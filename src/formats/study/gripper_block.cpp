#include "formats/study/gripper_block.hpp"

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
  constexpr auto required = GripperNumber::Presence::required;
  std::vector<GripperNumber> out{
      {.key = "mounting_angle_deg",
       .rule = Rule::between(-89.0, 89.0),
       .get = [](const GripperTask& task) { return task.mounting.angle; },
       .set = [](GripperTask& task, double value) { task.mounting.angle = value; }},
      {.key = "spacing_mm",
       .rule = up_to(1e3),
       .get = [](const GripperTask& task) { return task.mounting.spacing; },
       .set = [](GripperTask& task, double value) { task.mounting.spacing = value; }},
      {.key = "width_mm",
       .rule = up_to(1e3),
       .get = [](const GripperTask& task) { return task.object.width; },
       .set = [](GripperTask& task, double value) { task.object.width = value; },
       .presence = required},
      {.key = "mass_g",
       .rule = up_to(1e5),
       .get = [](const GripperTask& task) { return task.object.mass; },
       .set = [](GripperTask& task, double value) { task.object.mass = value; },
       .presence = required},
      {.key = "friction",
       .rule = up_to(10.0),
       .get = [](const GripperTask& task) { return task.object.friction; },
       .set = [](GripperTask& task, double value) { task.object.friction = value; },
       .presence = required},
      {.key = "centre_x_mm",
       .rule = base.mounting.fingers > 2 ? Rule::between(0.0, 0.0) : Rule::between(-1e3, 1e3),
       .get = [](const GripperTask& task) { return task.object.centre.x(); },
       .set = [](GripperTask& task, double value) { task.object.centre.x() = value; }},
      {.key = "centre_below_palm_mm",
       .rule = Rule::between(-1e3, 1e3),
       .get = [](const GripperTask& task) { return -task.object.centre.y(); },
       .set = [](GripperTask& task, double value) { task.object.centre.y() = -value; }},
      {.key = "open_current_A",
       .rule = Rule::between(-100.0, 100.0),
       .get = [](const GripperTask& task) { return task.open_current; },
       .set = [](GripperTask& task, double value) { task.open_current = value; }},
      {.key = "acceleration_m_s2",
       .rule = Rule::between(0.0, 1e3),
       .get = [](const GripperTask& task) { return task.acceleration; },
       .set = [](GripperTask& task, double value) { task.acceleration = value; }},
      {.key = "least_current_up_to_A",
       .rule = up_to(100.0),
       .get = [](const GripperTask& task) { return task.most_current; },
       .set = [](GripperTask& task, double value) { task.most_current = value; },
       .kind = GripperNumber::Kind::of_computation}};
  if (base.object.has_flat_sides())
    out.push_back({.key = "height_mm",
                   .rule = up_to(1e3),
                   .get = [](const GripperTask& task) { return task.object.height; },
                   .set = [](GripperTask& task, double value) { task.object.height = value; },
                   .presence = required});
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

std::vector<std::string> gripper_quantity_names() {
  std::vector<std::string> names;
  for (const simulation::ResultQuantity& each :
       systems::gripper::gripper_quantities([](const simulation::Settings&) { return GripperTask{}; }))
    names.push_back(each.name);
  return names;
}

}  // namespace coilwright::formats
