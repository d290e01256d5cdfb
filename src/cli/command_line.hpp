#pragma once

#include <span>

#include "cli/commands.hpp"

namespace coilwright::cli {

/// Runs the command that the arguments name: one of `commands`, which this program has, or of another program beside
/// it, which then takes the place of this one. Every error is one line on standard error, `coilwright: ...`.
[[nodiscard]] ExitCode run(std::span<const char* const> arguments, std::span<const Command> commands);

/// All of a program's main().
[[nodiscard]] int program(int argc, char** argv, std::span<const Command> commands);

}  // namespace coilwright::cli
