#include "command_names.hpp"

#include "coilwright/text/one_line.hpp"
#include "coilwright/text/spelling.hpp"

namespace coilwright::cli {

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  // A group of options is a command without a name.
  for (const CLI::App* command : app.get_subcommands([](const CLI::App* each) { return !each->get_name().empty(); }))
    names.push_back(command->get_name());
  return names;
}

std::string name_of(const CLI::App& command) {
  const CLI::App* parent = command.get_parent();
  return parent == nullptr ? command.get_name() : name_of(*parent) + " " + command.get_name();
}

std::string unknown_command(std::string_view word, std::span<const std::string> names) {
  return "unknown command " + text::in_quotes(word) + text::did_you_mean(word, names);
}

}  // namespace coilwright::cli
