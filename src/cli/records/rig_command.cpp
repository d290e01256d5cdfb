#include <CLI/CLI.hpp>

#include "cli/records/commands.hpp"

namespace coilwright::cli {

void add_rig_command(CLI::App& app, Outcome&) {
  CLI::App* command = add_command(app, "rig");
  command->require_subcommand(1);
  add_torque_bench(*command);
  add_stiffness_gauge(*command);
  add_grasp_bench(*command);
  add_camera(*command);
  command->footer(
      "Every rig prints its readings by both force fidelities: the exact force of the tilted, displaced pair, and the\n"
      "paper's force along the line of centres. With --out it writes them as a data set (measured-data/1), in which\n"
      "measured columns can take the place of the predicted ones.\n\n"
      "Example:\n"
      "  coilwright rig torque-bench configs/actuators/paper_finger.json --out results/torque_bench\n"
      "  coilwright diagnose results/torque_bench --out results/torque_bench_diagnosis");
}

}  // namespace coilwright::cli
