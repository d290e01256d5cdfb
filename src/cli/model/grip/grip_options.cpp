#include "cli/model/grip/grip_options.hpp"

#include "cli/options.hpp"
#include "coilwright/systems/gripper/gripper.hpp"

namespace coilwright::cli {
namespace {

using systems::gripper::Object;
using systems::gripper::ObjectShape;

ObjectShape shape_of(const GripOptions& options) {
  if (options.shape == "box") return ObjectShape::box;
  if (options.shape == "upright_cylinder") return ObjectShape::upright_cylinder;
  return options.shape == "cylinder" ? ObjectShape::cylinder : ObjectShape::sphere;
}

void add_object_options(CLI::App& command, GripOptions& options) {
  const auto positive_number = [&](double most, const char* name, double& value, const char* text) {
    return add_number(command, name, value, up_to(most), text);
  };
  add_word(command, "--shape", options.shape, {"sphere", "cylinder", "box", "upright_cylinder"},
           "sphere, cylinder (its axis across the fingers' plane), box, or upright_cylinder (a cup; default sphere)");
  positive_number(1e3, "--width-mm", options.width, "Diameter, or width of a box between the fingers, mm")->required();
  positive_number(1e3, "--height-mm", options.height, "Height of a box or an upright cylinder, mm");
  // Contacts are solved to a share of the fingers' impulses: what weighs less than a milligram is lost in that.
  add_number(command, "--mass-g", options.mass, text::Rule::between(1e-3, 1e5), "Mass of the object, g, at least 0.001")
      ->required();
  positive_number(10.0, "--friction", options.friction, "Coefficient of friction between it and the fingers")
      ->required();
  add_number(command, "--centre-x-mm", options.across, text::Rule::between(-1e3, 1e3),
             "Its centre from the middle between the fingers, mm (default 0)");
  add_number(command, "--centre-below-palm-mm", options.below, text::Rule::between(-1e3, 1e3),
             "Its centre below the line through the base joints, mm (default 16)");
}

void add_gripper_options(CLI::App& command, GripOptions& options) {
  add_number(command, "--mounting-angle-deg", options.mounting_angle, text::Rule::between(-89.0, 89.0),
             "Of each straight finger with the gripper's axis, outwards, deg (default 30)");
  add_number(
      command, "--fingers", options.fingers, text::Rule::between(2.0, systems::gripper::most_fingers),
      "How many, evenly round the gripper's axis (default 2); more than two hold a sphere or an upright cylinder");
  add_number(command, "--spacing-mm", options.spacing, up_to(1e3),
             "Between the two base joints, or diameter of the circle of more, mm (default 70)");
  add_word(command, "--polarity", options.polarity, {"same", "opposite"},
           "same (identical fingers, whose magnets repel) or opposite (every second one turned; default same)");
  add_number(command, "--current-A", options.current, text::Rule::between(-100.0, 100.0),
             "In every coil of all fingers, A (default that of the actuator's operating point, or the paper's 1.4)");
  add_number(command, "--open-current-A", options.open_current, text::Rule::between(-100.0, 100.0),
             "Before that, while the object is put between them, A; below zero it opens them (default 0)");
  add_number(command, "--acceleration-m_s2", options.acceleration, text::Rule::between(0.0, 1e3),
             "Upwards, that the hold must survive, m/s^2 (default 0)");
  const text::Rule above_zero = up_to(100.0);
  add_number(command, "--least-current-up-to-A", options.most_current, above_zero,
             "Also find the least current, up to this one, A");
  add_number(command, "--least-friction-up-to", options.most_friction, above_zero,
             "Also find the least coefficient of friction, up to this one");
}

}  // namespace

void add_grip_options(CLI::App& command, GripOptions& options) {
  add_actuator_options(command, options.actuator);
  add_object_options(command, options);
  add_gripper_options(command, options);
  add_json_option(command, options.json, "text");
}

Object object_of(const GripOptions& options) {
  return {.shape = shape_of(options),
          .width = options.width * 1e-3,
          .height = options.height * 1e-3,
          .mass = options.mass * 1e-3,
          .friction = options.friction,
          .centre = {options.across * 1e-3, -options.below * 1e-3}};
}

void require_height_of_shape(const GripOptions& options) {
  const bool has_height = object_of(options).has_flat_sides();
  if (has_height && options.height == 0.0)
    throw CLI::ValidationError("--height-mm", "is needed for a box and an upright cylinder");
  if (!has_height && options.height != 0.0)
    throw CLI::ValidationError(
        "--height-mm", "belongs to a box and an upright cylinder: --width-mm is all that a " + options.shape + " has");
}

}  // namespace coilwright::cli
