#include "cli/command_tree.hpp"

#include <string_view>

#include "coilwright/text/one_line.hpp"
#include "coilwright/text/spelling.hpp"

namespace coilwright::cli {

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  // A group of options is a command without a name; what is in no help has no group.
  for (const CLI::App* command : app.get_subcommands(
           [](const CLI::App* each) { return !each->get_name().empty() && !each->get_group().empty(); }))
    names.push_back(command->get_name());
  return names;
}

bool is_elsewhere(const CLI::App& app, std::string_view command) {
  return app.get_subcommand(std::string(command))->get_prefix_command();
}

std::string name_of(const CLI::App& command) {
  const CLI::App* parent = command.get_parent();
  return parent == nullptr ? command.get_name() : name_of(*parent) + " " + command.get_name();
}

std::string unknown_command(std::string_view word, std::span<const std::string> names) {
  return "unknown command " + text::in_quotes(word) + text::did_you_mean(word, names);
}

namespace {

void collect(const CLI::App& command, bool by_place, std::vector<const CLI::Option*>& found) {
  for (const CLI::Option* option : command.get_options())
    if (option->get_positional() == by_place && !option->get_name(by_place).empty()) found.push_back(option);
  // A group of options is a command without a name.
  for (const CLI::App* group : command.get_subcommands([](const CLI::App* each) { return each->get_name().empty(); }))
    collect(*group, by_place, found);
}

}  // namespace

std::vector<const CLI::Option*> options_of(const CLI::App& command) {
  std::vector<const CLI::Option*> found;
  collect(command, false, found);
  return found;
}

std::vector<const CLI::Option*> places_of(const CLI::App& command) {
  std::vector<const CLI::Option*> found;
  collect(command, true, found);
  return found;
}

std::vector<std::string> names_of(const CLI::Option& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.get_snames()) names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  return names;
}

std::vector<std::string> words_of(const CLI::Option& option) {
  constexpr std::string_view start = "One of ", between = ", ";
  const std::string& description = option.get_description();
  const std::size_t at = description.rfind(start);
  std::vector<std::string> words;
  if (at == std::string::npos) return words;
  std::string_view rest = std::string_view(description).substr(at + start.size());
  while (!rest.empty()) {
    const std::size_t end = rest.find(between);
    words.emplace_back(rest.substr(0, end));
    rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + between.size());
  }
  return words;
}

}  // namespace coilwright::cli
