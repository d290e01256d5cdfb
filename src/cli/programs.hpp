#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace coilwright::cli {

/// A row of commands.def.
struct CommandPlace {
  std::string_view name;
  std::string_view program;  ///< "search": coilwright-search
  std::string_view help;     ///< its line
};

/// All commands, in the order of the help.
[[nodiscard]] std::span<const CommandPlace> command_places();

/// The command of this name; nullptr where there is none.
[[nodiscard]] const CommandPlace* place_of(std::string_view command);

/// Replaces this process by a program beside it ("search"), with these arguments, the name of the process first. Throws
/// std::runtime_error that says how to get the program where it is not there.
[[noreturn]] void go_on_in(std::string_view program, std::span<const char* const> arguments);

/// What a program printed that ended well.
struct Printed {
  std::string output;  ///< on standard output
  std::string errors;  ///< and on standard error
};

/// Runs a program beside this one and waits for its end. Throws std::runtime_error with its line where it fails, and as
/// go_on_in() does.
[[nodiscard]] Printed run_program(std::string_view program, const std::vector<std::string>& arguments);

/// How a program ended that failed.
struct Failure {
  int code{};
  std::string line;  ///< what it said, without "coilwright: "
};

/// Runs this program itself with other arguments in `folder` for at most `longest`, and kills it if it still runs then.
/// Nothing where it did, or ended well or without a feasible design. Throws as go_on_in() does.
[[nodiscard]] std::optional<Failure> failure_within(std::chrono::milliseconds longest,
                                                    const std::filesystem::path& folder,
                                                    const std::vector<std::string>& arguments);

}  // namespace coilwright::cli
