#include "formats/study/system_block.hpp"

#include "coilwright/systems/gripper/quantities.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using systems::gripper::GripperTask;
using systems::gripper::Polarity;

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
    // Choices and the number of fingers say which numbers there are.
    auto choices = grip_rows({});
    std::erase_if(choices, [](const auto& row) { return row.words.empty() && !row.whole; });
    GripperTask task = read_rows(in, choices, GripperTask{});
    require_possible(in, task);
    const auto rows = grip_rows(task);
    task = read_rows(in, rows, task);
    return SystemBlock{.quantities = systems::gripper::gripper_quantities(task_by<GripperTask>("gripper", rows, task)),
                       .variables = variables_of<GripperTask>("gripper", rows, task),
                       .require_suitable = require_no_states};
  });
}

}  // namespace coilwright::formats
