#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "command_names.hpp"
#include "commands.hpp"
#include "outcome.hpp"

namespace coilwright::cli {
namespace {

// The command that the words name, one below the other: {"rig", "camera"}.
const CLI::App& command_named(const CLI::App& app, const std::vector<std::string>& words) {
  const CLI::App* found = &app;
  for (const std::string& word : words) {
    const auto names = command_names(*found);
    if (std::ranges::count(names, word) == 0) throw CLI::ValidationError(unknown_command(word, names));
    found = found->get_subcommand(word);
  }
  return *found;
}

}  // namespace

void add_help_command(CLI::App& app, Outcome&) {
  auto words = std::make_shared<std::vector<std::string>>();
  CLI::App* command = app.add_subcommand("help", "Print this help, or that of a command");
  command->add_option("COMMAND", *words, "The command to explain (default: the program)");
  command->footer("Example:\n  coilwright help size");
  command->callback([words, &app] {
    const CLI::App& asked = command_named(app, *words);
    // App::help() of the program would be that of the command that runs, which is this one.
    std::cout << app.get_formatter()->make_help(&asked, name_of(asked), CLI::AppFormatMode::Normal);
  });
}

}  // namespace coilwright::cli
