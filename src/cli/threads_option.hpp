#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace coilwright::cli {

/// --threads of a command: `what` is done at once, "Fits made at once". No result depends on it, so what exceeds the
/// cores that this process may run on counts as their number: more would only take turns, and TBB warns of some.
void add_threads_option(CLI::App& command, int& threads, const std::string& what);

}  // namespace coilwright::cli
