#pragma once

#include <CLI/CLI.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace coilwright::cli {

/// The names of the commands right below `app`, in the order of its help.
[[nodiscard]] std::vector<std::string> command_names(const CLI::App& app);

/// "coilwright rig torque-bench".
[[nodiscard]] std::string name_of(const CLI::App& command);

/// `unknown command "forse"; did you mean "force"?`.
[[nodiscard]] std::string unknown_command(std::string_view word, std::span<const std::string> names);

}  // namespace coilwright::cli
