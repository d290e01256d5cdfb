#include "cli/model/commands.hpp"

#include <array>

#include "cli/model/evaluate_command.hpp"

namespace coilwright::cli {

std::span<const Command> model_commands() {
  static constexpr std::array commands{
      Command{"evaluate", [](CLI::App& app, Outcome& outcome) { add_evaluate(app, outcome, {}); }},
      Command{"simulate", &add_simulate_command},
      Command{"linearise", &add_linearise_command},
      Command{"reach", &add_reach_command},
      Command{"force", &add_force_command},
      Command{"field", &add_field_command},
      Command{"drive", &add_drive_command},
      Command{"grip", &add_grip_command},
      Command{"crawl", &add_crawl_command},
  };
  return commands;
}

}  // namespace coilwright::cli
