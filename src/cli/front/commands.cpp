#include "cli/front/commands.hpp"

#include <array>

#include "cli/front/init_command.hpp"

namespace coilwright::cli {

std::span<const Command> front_commands() {
  static constexpr std::array commands{
      Command{"init", [](CLI::App& app, Outcome& outcome) { add_init(app, outcome, {}); }},
      Command{"schema", &add_schema_command},
  };
  return commands;
}

}  // namespace coilwright::cli
