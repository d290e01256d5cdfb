#pragma once

#include "cli/outcome.hpp"

namespace CLI {
class App;
}

namespace coilwright::cli {

/// Each adds one command below `archive`.
void add_archive_list(CLI::App& command);
void add_archive_filter(CLI::App& command);
void add_archive_top(CLI::App& command);
void add_archive_csv(CLI::App& command);
void add_archive_pick(CLI::App& command);
void add_archive_check(CLI::App& command);
/// `outcome` is a failure where a design gives other numbers.
void add_archive_replay(CLI::App& command, Outcome& outcome);

}  // namespace coilwright::cli
