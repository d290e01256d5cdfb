#include "cli/command_line.hpp"

int main(int argc, char** argv) {
  return coilwright::cli::program(argc, argv, coilwright::cli::bench_commands());
}
