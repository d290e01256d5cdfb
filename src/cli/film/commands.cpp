#include "cli/film/commands.hpp"

#include <array>

namespace coilwright::cli {

std::span<const Command> film_commands() {
  static constexpr std::array commands{
      Command{"tag", &add_tag_command},
      Command{"lens", &add_lens_command},
      Command{"track", &add_track_command},
  };
  return commands;
}

}  // namespace coilwright::cli
