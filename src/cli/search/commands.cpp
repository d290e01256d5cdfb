#include "cli/search/commands.hpp"

#include <array>

namespace coilwright::cli {

std::span<const Command> search_commands() {
  static constexpr std::array commands{
      Command{"size", &add_size_command},       Command{"sweep", &add_sweep_command},
      Command{"pareto", &add_pareto_command},   Command{"yield", &add_yield_command},
      Command{"archive", &add_archive_command}, Command{"list", &add_list_command},
  };
  return commands;
}

}  // namespace coilwright::cli
