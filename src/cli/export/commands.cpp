#include "cli/export/commands.hpp"

#include <array>

namespace coilwright::cli {

std::span<const Command> export_commands() {
  static constexpr std::array commands{
      Command{"export", &add_export_command},
  };
  return commands;
}

}  // namespace coilwright::cli
