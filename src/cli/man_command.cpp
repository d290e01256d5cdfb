#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <string>

#include "coilwright/text/output/output_folder.hpp"
#include "command_names.hpp"
#include "commands.hpp"
#include "manual_page.hpp"
#include "outcome.hpp"

namespace coilwright::cli {
namespace {

void write_pages(const CLI::App& command, text::OutputFolder& folder) {
  folder.write(manual_page_name(command), manual_page(command));
  for (const std::string& name : command_names(command)) write_pages(*command.get_subcommand(name), folder);
}

}  // namespace

void add_man_command(CLI::App& app, Outcome&) {
  auto out = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("man", "Write the manual pages of all commands");
  command->add_option("--out", *out, "Folder for the pages; it is created if it does not exist")->required();
  command->footer("Example:\n  coilwright man --out man1 && man -l man1/coilwright-size.1");
  command->callback([out, &app] {
    text::OutputFolder folder(*out);
    write_pages(app, folder);
    folder.commit();
  });
}

}  // namespace coilwright::cli
