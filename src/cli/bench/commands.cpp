#include "cli/bench/commands.hpp"

#include <array>

namespace coilwright::cli {

std::span<const Command> bench_commands() {
  static constexpr std::array commands{Command{"bench", &add_bench_command}};
  return commands;
}

}  // namespace coilwright::cli
