#include "cli/model/grip/grip_options.hpp"

#include <fmt/format.h>

#include "cli/model/task_options.hpp"

namespace coilwright::cli {

using systems::gripper::GripperTask;

void add_grip_options(CLI::App& command, GripOptions& options) {
  add_actuator_options(command, options.actuator);
  // The height of what has one, which the check of the task asks for.
  add_rows(command, formats::grip_rows({.object = {.shape = systems::gripper::ObjectShape::box}}), options.task);
  command.get_option("--height-mm")->required(false);
  add_number(command, "--current-A", options.current, text::Rule::between(-100.0, 100.0),
             "In every coil of all fingers, A; otherwise that of the actuator's operating point, or the paper's 1.4");
  add_number(command, "--least-friction-up-to", options.most_friction, up_to(100.0),
             "Also find the least coefficient of friction, up to this one");
  add_json_option(command, options.json, "text");
}

void check(const GripperTask& task) {
  const bool has_height = task.object.has_flat_sides();
  if (has_height && task.object.height == 0.0)
    throw CLI::ValidationError("--height-mm", "is needed for a box and an upright cylinder");
  if (!has_height && task.object.height != 0.0)
    throw CLI::ValidationError("--height-mm",
                               fmt::format("belongs to a box and an upright cylinder: --width-mm is all that a {} has",
                                           name_of(task.object.shape)));
}

}  // namespace coilwright::cli
