#pragma once

#include "cli/commands.hpp"

namespace coilwright::cli {

void add_bench_command(CLI::App& app, Outcome& outcome);

}  // namespace coilwright::cli
