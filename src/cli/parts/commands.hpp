#pragma once

#include "cli/commands.hpp"

namespace coilwright::cli {

void add_distribute_command(CLI::App& app, Outcome& outcome);
void add_merge_command(CLI::App& app, Outcome& outcome);

}  // namespace coilwright::cli
