#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "cli/actuator_input.hpp"
#include "coilwright/systems/gripper/quantities.hpp"

namespace coilwright::cli {

/// What `grip` is told on the command line.
struct GripOptions {
  ActuatorOptions actuator;
  systems::gripper::GripperTask task;  ///< but for shape and polarity, of which there are words
  std::string polarity = "same";
  std::string shape = "sphere";
  std::optional<double> current{};  ///< nothing: the file's own, or the paper's
  double most_friction{};
  bool json{false};
};

/// Adds them to `command`.
void add_grip_options(CLI::App& command, GripOptions& options);

/// The task with the words. Throws CLI::ValidationError where height and shape of the object do not belong together.
[[nodiscard]] systems::gripper::GripperTask task_of(const GripOptions& options);

}  // namespace coilwright::cli
