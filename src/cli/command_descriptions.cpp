#include "cli/command_descriptions.hpp"

#include <algorithm>
#include <iostream>
#include <utility>

#include "cli/command_tree.hpp"
#include "cli/commands.hpp"
#include "cli/manual_page.hpp"
#include "cli/programs.hpp"
#include "coilwright/text/json/document.hpp"
#include "coilwright/text/json/json.hpp"

namespace coilwright::cli {
namespace {

using text::Json;

void add_pages(const CLI::App& command, std::map<std::string, std::string>& pages) {
  pages.emplace(manual_page_name(command), manual_page(command));
  for (const std::string& name : command_names(command)) add_pages(*command.get_subcommand(name), pages);
}

CommandDescription description_of(const CLI::App& command, const CLI::App& app) {
  CommandDescription out{.completion = completion_of(command, app), .pages = {}};
  add_pages(command, out.pages);
  return out;
}

Json to_json(const CommandDescription& description) {
  Json pages = Json::object();
  for (const auto& [name, page] : description.pages) pages.set(name, page);
  return Json::object({{"words", description.completion.words},
                       {"values", description.completion.values},
                       {"pages", std::move(pages)}});
}

CommandDescription from_json(const text::Node& node) {
  CommandDescription out{
      .completion = {.words = node.find("words").value().text(), .values = node.find("values").value().text()},
      .pages = {}};
  for (const text::Node& page : node.find("pages").value().members()) out.pages.emplace(page.key(), page.text());
  return out;
}

}  // namespace

std::vector<CommandDescription> descriptions(const CLI::App& app) {
  std::map<std::string, text::Document, std::less<>> told;  // by program
  std::vector<CommandDescription> out;
  for (const std::string& name : command_names(app)) {
    if (!is_elsewhere(app, name)) {
      out.push_back(description_of(*app.get_subcommand(name), app));
      continue;
    }
    const std::string program(place_of(name)->program);
    if (!told.contains(program)) {
      told.emplace(program, text::parse_json(run_program(program, {"describe"}).output, program));
    }
    out.push_back(from_json(told.at(program).root().find(name).value()));
  }
  return out;
}

void add_describe_command(CLI::App& app, Outcome&) {
  CLI::App* command = app.add_subcommand("describe", "Print what the other programs are told of these commands");
  command->group("");  // in no help
  command->callback([&app] {
    Json all = Json::object();
    for (const std::string& name : command_names(app))
      if (place_of(name) != nullptr && !is_elsewhere(app, name))
        all.set(name, to_json(description_of(*app.get_subcommand(name), app)));
    std::cout << all.text();
  });
}

}  // namespace coilwright::cli
