// What the program tells of itself.
#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "cli/command_descriptions.hpp"
#include "cli/command_tree.hpp"
#include "cli/commands.hpp"
#include "cli/manual_page.hpp"
#include "cli/options.hpp"
#include "cli/outputs.hpp"
#include "coilwright/results/build_info.hpp"
#include "coilwright/text/output/output_folder.hpp"

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

namespace {

void write_pages(const CLI::App& app, text::OutputFolder& folder) {
  folder.write(manual_page_name(app), manual_page(app));
  for (const CommandDescription& each : descriptions(app))
    for (const auto& [name, page] : each.pages) folder.write(name, page);
}

}  // namespace

void add_man_command(CLI::App& app, Outcome&) {
  auto out = std::make_shared<std::string>();
  auto force = std::make_shared<bool>(false);
  CLI::App* command = app.add_subcommand("man", "Write the manual pages of all commands");
  command->add_option("--out", *out, "Folder for the pages; it is created if it does not exist")->required();
  add_force_option(*command, *force);
  command->footer("Example:\n  coilwright man --out man1 && man -l man1/coilwright-size.1");
  command->callback([out, force, &app] {
    text::OutputFolder folder(*out);
    write_pages(app, folder);
    keep_others(folder, *force);
    folder.commit();
  });
}

void add_version_command(CLI::App& app, Outcome&) {
  auto json = std::make_shared<bool>(false);
  CLI::App* command =
      app.add_subcommand("version", "Print the version, the commit it was built from and the libraries");
  add_json_option(*command, *json, "text");
  command->footer("Example:\n  coilwright version --json");
  command->callback([json] { std::cout << (*json ? results::version_json().text() : results::version_text() + '\n'); });
}

}  // namespace coilwright::cli
