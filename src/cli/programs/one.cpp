#include <vector>

#include "cli/command_line.hpp"

// All commands in one program. Of a name that is there twice the first counts: the one that needs no other program.
int main(int argc, char** argv) {
  using namespace coilwright::cli;
  std::vector<Command> commands;
  for (const auto some : {page_commands(), records_commands(), front_commands(), model_commands(), search_commands(),
                          parts_commands(), film_commands(), export_commands(), bench_commands()})
    commands.insert(commands.end(), some.begin(), some.end());
  return program(argc, argv, commands);
}
