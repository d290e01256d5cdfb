#pragma once

#include "cli/commands.hpp"

namespace coilwright::cli {

void add_diagnose_command(CLI::App& app, Outcome& outcome);
void add_plan_command(CLI::App& app, Outcome& outcome);
void add_twin_command(CLI::App& app, Outcome& outcome);
void add_rig_command(CLI::App& app, Outcome& outcome);

/// Each adds one rig below the command `rig`.
///@{
void add_torque_bench(CLI::App& command);
void add_stiffness_gauge(CLI::App& command);
void add_grasp_bench(CLI::App& command);
void add_camera(CLI::App& command);
///@}

}  // namespace coilwright::cli
