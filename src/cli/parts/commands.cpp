#include "cli/parts/commands.hpp"

#include <array>

namespace coilwright::cli {

std::span<const Command> parts_commands() {
  static constexpr std::array commands{
      Command{"distribute", &add_distribute_command},
      Command{"merge", &add_merge_command},
  };
  return commands;
}

}  // namespace coilwright::cli
