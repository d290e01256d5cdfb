#include <vector>

#include "cli/command_line.hpp"

// The commands of a run in parts: to give it away, to make a part of it, and to put it together. One program, as it is
// copied to other machines.
int main(int argc, char** argv) {
  using namespace coilwright::cli;
  std::vector<Command> commands;
  for (const auto some : {parts_commands(), search_commands(), records_commands()})
    commands.insert(commands.end(), some.begin(), some.end());
  return program(argc, argv, commands);
}
