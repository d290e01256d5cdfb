#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "cli/actuator_input.hpp"
#include "coilwright/systems/gripper/object.hpp"

namespace coilwright::cli {

/// What `grip` is told on the command line, each in the unit of its option's name.
struct GripOptions {
  ActuatorOptions actuator;
  double mounting_angle = 30.0;
  double spacing = 70.0;
  int fingers = 2;
  std::string polarity = "same";
  std::string shape = "sphere";
  double width{};
  double height{};
  double mass{};
  double friction{};
  double across = 0.0;
  double below = 16.0;
  std::optional<double> current{};  ///< nothing: the file's own, or the paper's
  double open_current = 0.0;
  double acceleration = 0.0;
  double most_current{};
  double most_friction{};
  bool json{false};
};

/// Adds them to `command`.
void add_grip_options(CLI::App& command, GripOptions& options);

/// The object that is gripped, in SI units.
[[nodiscard]] systems::gripper::Object object_of(const GripOptions& options);

/// Throws CLI::ValidationError where the height and the shape of the object do not belong together.
void require_height_of_shape(const GripOptions& options);

}  // namespace coilwright::cli
