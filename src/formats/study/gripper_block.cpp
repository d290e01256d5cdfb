#include "formats/study/system_block.hpp"

#include "coilwright/systems/gripper/quantities.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using systems::gripper::GripperTask;
using systems::gripper::ObjectShape;
using systems::gripper::Polarity;
using GripperNumber = BlockNumber<GripperTask>;

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
    const std::vector<GripperNumber> numbers = grip_numbers(task);
    read_numbers<GripperTask>(in, numbers, task);
    return SystemBlock{.quantities = systems::gripper::gripper_quantities(task_by("gripper", numbers, task)),
                       .variables = variables_of<GripperTask>("gripper", numbers, task),
                       .require_suitable = require_no_states};
  });
}

}  // namespace coilwright::formats
