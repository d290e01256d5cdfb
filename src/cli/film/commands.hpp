#pragma once

#include "cli/commands.hpp"

namespace coilwright::cli {

void add_tag_command(CLI::App& app, Outcome& outcome);
void add_lens_command(CLI::App& app, Outcome& outcome);
void add_track_command(CLI::App& app, Outcome& outcome);

}  // namespace coilwright::cli
