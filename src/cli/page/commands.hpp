#pragma once

#include "cli/commands.hpp"

namespace coilwright::cli {

void add_report_command(CLI::App& app, Outcome& outcome);
void add_validate_command(CLI::App& app, Outcome& outcome);

}  // namespace coilwright::cli
