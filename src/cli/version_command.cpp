#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "build_info.hpp"
#include "commands.hpp"
#include "outcome.hpp"

namespace coilwright::cli {

void add_version_command(CLI::App& app, Outcome&) {
  auto json = std::make_shared<bool>(false);
  CLI::App* command =
      app.add_subcommand("version", "Print the version, the commit it was built from and the libraries");
  command->add_flag("--json", *json, "Print JSON instead of text")->disable_flag_override();
  command->footer("Example:\n  coilwright version --json");
  command->callback([json] { std::cout << (*json ? version_json().text() : version_text() + '\n'); });
}

}  // namespace coilwright::cli
