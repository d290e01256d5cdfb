#include "grip_options.hpp"

#include "cli/number_rule.hpp"
#include "cli/word_rule.hpp"
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
  const auto up_to = [&](double most, const char* name, double& value, const char* text) {
    return command.add_option(name, value, text)
        ->check(number_rule(text::Rule::above(0.0).and_also(text::Rule::at_most(most))));
  };
  command
      .add_option(
          "--shape", options.shape,
          "sphere, cylinder (its axis across the fingers' plane), box, or upright_cylinder (a cup; default sphere)")
      ->check(word_rule({"sphere", "cylinder", "box", "upright_cylinder"}));
  up_to(1e3, "--width-mm", options.width, "Diameter, or width of a box between the fingers, mm")->required();
  up_to(1e3, "--height-mm", options.height, "Height of a box or an upright cylinder, mm");
  // Contacts are solved to a share of the fingers' impulses: what weighs less than a milligram is lost in that.
  command.add_option("--mass-g", options.mass, "Mass of the object, g, at least 0.001")
      ->check(number_rule(text::Rule::between(1e-3, 1e5)))
      ->required();
  up_to(10.0, "--friction", options.friction, "Coefficient of friction between it and the fingers")->required();
  command.add_option("--centre-x-mm", options.across, "Its centre from the middle between the fingers, mm (default 0)")
      ->check(number_rule(text::Rule::between(-1e3, 1e3)));
  command
      .add_option("--centre-below-palm-mm", options.below,
                  "Its centre below the line through the base joints, mm (default 16)")
      ->check(number_rule(text::Rule::between(-1e3, 1e3)));
}

void add_gripper_options(CLI::App& command, GripOptions& options) {
  command
      .add_option("--mounting-angle-deg", options.mounting_angle,
                  "Of each straight finger with the gripper's axis, outwards, deg (default 30)")
      ->check(number_rule(text::Rule::between(-89.0, 89.0)));
  command
      .add_option(
          "--fingers", options.fingers,
          "How many, evenly round the gripper's axis (default 2); more than two hold a sphere or an upright cylinder")
      ->check(number_rule(text::Rule::between(2.0, systems::gripper::most_fingers)));
  command
      .add_option("--spacing-mm", options.spacing,
                  "Between the two base joints, or diameter of the circle of more, mm (default 70)")
      ->check(number_rule(text::Rule::above(0.0).and_also(text::Rule::at_most(1e3))));
  command
      .add_option("--polarity", options.polarity,
                  "same (identical fingers, whose magnets repel) or opposite (every second one turned; default same)")
      ->check(word_rule({"same", "opposite"}));
  command
      .add_option(
          "--current-A", options.current,
          "In every coil of all fingers, A (default that of the actuator's operating point, or the paper's 1.4)")
      ->check(number_rule(text::Rule::between(-100.0, 100.0)));
  command
      .add_option("--open-current-A", options.open_current,
                  "Before that, while the object is put between them, A; below zero it opens them (default 0)")
      ->check(number_rule(text::Rule::between(-100.0, 100.0)));
  command
      .add_option("--acceleration-m_s2", options.acceleration, "Upwards, that the hold must survive, m/s^2 (default 0)")
      ->check(number_rule(text::Rule::between(0.0, 1e3)));
  const text::Rule above_zero = text::Rule::above(0.0).and_also(text::Rule::at_most(100.0));
  command.add_option("--least-current-up-to-A", options.most_current, "Also find the least current, up to this one, A")
      ->check(number_rule(above_zero));
  command
      .add_option("--least-friction-up-to", options.most_friction,
                  "Also find the least coefficient of friction, up to this one")
      ->check(number_rule(above_zero));
}

}  // namespace

void add_grip_options(CLI::App& command, GripOptions& options) {
  add_actuator_options(command, options.actuator);
  add_object_options(command, options);
  add_gripper_options(command, options);
  command.add_flag("--json", options.json, "Print JSON instead of text")->disable_flag_override();
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
