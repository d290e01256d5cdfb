#pragma once

#include "cli/commands.hpp"

namespace coilwright::cli {

void add_size_command(CLI::App& app, Outcome& outcome);
void add_sweep_command(CLI::App& app, Outcome& outcome);
void add_pareto_command(CLI::App& app, Outcome& outcome);
void add_yield_command(CLI::App& app, Outcome& outcome);
void add_archive_command(CLI::App& app, Outcome& outcome);
void add_list_command(CLI::App& app, Outcome& outcome);

/// Each adds one command below `archive`.
///@{
void add_archive_list(CLI::App& command);
void add_archive_filter(CLI::App& command);
void add_archive_top(CLI::App& command);
void add_archive_csv(CLI::App& command);
void add_archive_pick(CLI::App& command);
void add_archive_check(CLI::App& command, Outcome& outcome);
///@}
/// The same; `outcome` is a failure where a design gives other numbers.
void add_archive_replay(CLI::App& command, Outcome& outcome);

}  // namespace coilwright::cli
