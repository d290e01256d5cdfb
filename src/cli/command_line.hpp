#pragma once

#include <span>

#include "commands.hpp"

namespace coilwright::cli {

/// Runs the command that the arguments name. Every error is one line on standard error, `coilwright: ...`.
[[nodiscard]] ExitCode run(std::span<const char* const> arguments, std::span<const AddCommand> commands);

}  // namespace coilwright::cli
