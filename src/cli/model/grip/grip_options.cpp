#include "cli/model/grip/grip_options.hpp"

#include "cli/model/task_options.hpp"

namespace coilwright::cli {

using systems::gripper::GripperTask;

void add_grip_options(CLI::App& command, GripOptions& options) {
  add_actuator_options(command, options.actuator);
  const auto rows = formats::grip_numbers({.object = {.shape = systems::gripper::ObjectShape::box}});
  const auto number = [&](const char* key, const char* text) {
    return add_number_of(command, rows, key, options.task, text);
  };
  add_word(command, "--shape", options.shape, {"sphere", "cylinder", "box", "upright_cylinder"},
           "sphere, cylinder (its axis across the fingers' plane), box, or upright_cylinder (a cup; default sphere)");
  number("width_mm", "Diameter, or width of a box between the fingers, mm");
  number("height_mm", "Height of a box or an upright cylinder, mm")->required(false);
  number("mass_g", "Mass of the object, g, at least 0.001");
  number("friction", "Coefficient of friction between it and the fingers");
  number("centre_x_mm", "Its centre from the middle between the fingers, mm (default 0)");
  number("centre_below_palm_mm", "Its centre below the line through the base joints, mm (default 16)");
  number("mounting_angle_deg", "Of each straight finger with the gripper's axis, outwards, deg (default 30)");
  add_number(
      command, "--fingers", options.task.mounting.fingers, text::Rule::between(2.0, systems::gripper::most_fingers),
      "How many, evenly round the gripper's axis (default 2); more than two hold a sphere or an upright cylinder");
  number("spacing_mm", "Between the two base joints, or diameter of the circle of more, mm (default 70)");
  add_word(command, "--polarity", options.polarity, {"same", "opposite"},
           "same (identical fingers, whose magnets repel) or opposite (every second one turned; default same)");
  add_number(command, "--current-A", options.current, text::Rule::between(-100.0, 100.0),
             "In every coil of all fingers, A (default that of the actuator's operating point, or the paper's 1.4)");
  number("open_current_A",
         "Before that, while the object is put between them, A; below zero it opens them (default 0)");
  number("acceleration_m_s2", "Upwards, that the hold must survive, m/s^2 (default 0)");
  number("least_current_up_to_A", "Also find the least current, up to this one, A");
  add_number(command, "--least-friction-up-to", options.most_friction, up_to(100.0),
             "Also find the least coefficient of friction, up to this one");
  add_json_option(command, options.json, "text");
}

GripperTask task_of(const GripOptions& options) {
  GripperTask task = options.task;
  task.object.shape = formats::shape_named(options.shape);
  if (options.polarity == "opposite") task.mounting.polarity = systems::gripper::Polarity::opposite;
  const bool has_height = task.object.has_flat_sides();
  if (has_height && task.object.height == 0.0)
    throw CLI::ValidationError("--height-mm", "is needed for a box and an upright cylinder");
  if (!has_height && task.object.height != 0.0)
    throw CLI::ValidationError(
        "--height-mm", "belongs to a box and an upright cylinder: --width-mm is all that a " + options.shape + " has");
  return task;
}

}  // namespace coilwright::cli
