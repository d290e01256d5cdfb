#pragma once

#include <CLI/CLI.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace coilwright::cli {

/// The names of the commands right below `app`, in the order of its help.
[[nodiscard]] std::vector<std::string> command_names(const CLI::App& app);

/// Whether another program has this command of `app`: here it has no options then, and takes whatever comes.
[[nodiscard]] bool is_elsewhere(const CLI::App& app, std::string_view command);

/// "coilwright rig torque-bench".
[[nodiscard]] std::string name_of(const CLI::App& command);

/// `unknown command "forse"; did you mean "force"?`.
[[nodiscard]] std::string unknown_command(std::string_view word, std::span<const std::string> names);

/// The options of a command, those of its groups too, in the order of its help; without what is given by place.
[[nodiscard]] std::vector<const CLI::Option*> options_of(const CLI::App& command);

/// What is given by place, in its order.
[[nodiscard]] std::vector<const CLI::Option*> places_of(const CLI::App& command);

/// Every name of an option with its dashes, the short one first: {"-h", "--help"}.
[[nodiscard]] std::vector<std::string> names_of(const CLI::Option& option);

/// The words that an option takes where its description ends with "One of a, b, c"; else empty.
[[nodiscard]] std::vector<std::string> words_of(const CLI::Option& option);

}  // namespace coilwright::cli
