#include "cli/records/commands.hpp"

#include <array>

#include "cli/front/init_command.hpp"

namespace coilwright::cli {

std::span<const Command> records_commands() {
  static constexpr std::array commands{
      Command{"diagnose", &add_diagnose_command},
      Command{"plan", &add_plan_command},
      Command{"twin", &add_twin_command},
      Command{"rig", &add_rig_command},
      Command{"init", [](CLI::App& app, Outcome& outcome) { add_init(app, outcome, &formats::draft_dataset); }},
  };
  return commands;
}

}  // namespace coilwright::cli
