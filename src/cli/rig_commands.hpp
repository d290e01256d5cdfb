#pragma once

namespace CLI {
class App;
}

namespace coilwright::cli {

/// Each adds one rig below the command `rig`.
void add_torque_bench(CLI::App& command);
void add_stiffness_gauge(CLI::App& command);
void add_grasp_bench(CLI::App& command);
void add_camera(CLI::App& command);

}  // namespace coilwright::cli
