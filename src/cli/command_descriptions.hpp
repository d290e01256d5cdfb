#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <string>
#include <vector>

namespace coilwright::cli {

/// What a command gives to the functions of a completion script.
struct CompletionLines {
  std::string words;   ///< what may stand behind it: its options, its first words
  std::string values;  ///< and behind its options
};

/// Of a command right below `app`, and of those below it.
[[nodiscard]] CompletionLines completion_of(const CLI::App& command, const CLI::App& app);

/// What shells and man are told of a command right below the program, and of those below it.
struct CommandDescription {
  CompletionLines completion;
  std::map<std::string, std::string> pages;  ///< manual pages by their file
};

/// Of all commands, in the order of the help: those that are in other programs are asked of these. Throws
/// std::runtime_error where one is not there.
[[nodiscard]] std::vector<CommandDescription> descriptions(const CLI::App& app);

}  // namespace coilwright::cli
