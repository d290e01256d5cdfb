#pragma once

#include <CLI/CLI.hpp>
#include <optional>

#include "cli/actuator_input.hpp"
#include "coilwright/systems/gripper/quantities.hpp"

namespace coilwright::cli {

/// What `grip` is told on the command line.
struct GripOptions {
  ActuatorOptions actuator;
  systems::gripper::GripperTask task;
  std::optional<double> current{};  ///< nothing: the file's own, or the paper's
  double most_friction{};
  bool json{false};
};

/// Adds them to `command`.
void add_grip_options(CLI::App& command, GripOptions& options);

/// Throws CLI::ValidationError where height and shape of the object do not belong together.
void check(const systems::gripper::GripperTask& task);

}  // namespace coilwright::cli
