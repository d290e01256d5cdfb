#include <CLI/CLI.hpp>

#include "cli/search/commands.hpp"

namespace coilwright::cli {

void add_archive_command(CLI::App& app, Outcome& outcome) {
  CLI::App* command = add_command(app, "archive");
  command->require_subcommand(1);
  add_archive_list(*command);
  add_archive_filter(*command);
  add_archive_top(*command);
  add_archive_csv(*command);
  add_archive_pick(*command);
  add_archive_replay(*command, outcome);
  add_archive_check(*command, outcome);
  command->footer(
      "DIR is the folder that was given as --out; its archive may be read while a run writes to it. A row is a "
      "design's\n"
      "place in the order of recording, and the first column of what filter, top and csv print.\n\n"
      "Example:\n"
      "  coilwright archive top results/fastest_finger --most grasp_force_N --count 3\n"
      "  coilwright archive pick results/fastest_finger --row 17 --out actuator.json");
}

}  // namespace coilwright::cli
