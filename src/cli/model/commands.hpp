#pragma once

#include "cli/commands.hpp"

namespace coilwright::cli {

void add_simulate_command(CLI::App& app, Outcome& outcome);
void add_linearise_command(CLI::App& app, Outcome& outcome);
void add_reach_command(CLI::App& app, Outcome& outcome);
void add_force_command(CLI::App& app, Outcome& outcome);
void add_field_command(CLI::App& app, Outcome& outcome);
void add_drive_command(CLI::App& app, Outcome& outcome);
void add_grip_command(CLI::App& app, Outcome& outcome);
void add_crawl_command(CLI::App& app, Outcome& outcome);

}  // namespace coilwright::cli
