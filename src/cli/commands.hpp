#pragma once

#include <span>
#include <stdexcept>
#include <string_view>

namespace CLI {
class App;
}

namespace coilwright::cli {

/// How the program ends; the numbers are part of its interface.
enum class ExitCode : int {
  done = 0,
  failure = 1,        ///< anything else
  bad_input = 2,      ///< an input or the usage is wrong, or a place for results cannot be written
  infeasible = 3,     ///< no design keeps all limits; the least infeasible one is written
  other_machine = 4,  ///< of a part: this machine gives other numbers than the one that gathers the parts
  interrupted = 130   ///< stopped by a signal; what was found so far is written
};

/// Ends the program with ExitCode::other_machine.
class OtherMachine : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What a command was called with, and leaves behind.
struct Outcome {
  ExitCode code = ExitCode::done;
  std::span<const char* const> arguments{};  ///< of the process, its name first
};

/// Adds one command to the program: its options, its help with an example, and what it does, which sets `outcome` when
/// it ends otherwise than well. `outcome` outlives the parsing.
using AddCommand = void (*)(CLI::App& app, Outcome& outcome);

/// A command that a program has.
struct Command {
  std::string_view name;
  AddCommand add;
};

/// The commands of the programs, each in the folder of its name: what coilwright-model has, and so on.
///@{
[[nodiscard]] std::span<const Command> front_commands();
[[nodiscard]] std::span<const Command> model_commands();
[[nodiscard]] std::span<const Command> search_commands();
[[nodiscard]] std::span<const Command> parts_commands();
[[nodiscard]] std::span<const Command> records_commands();
[[nodiscard]] std::span<const Command> film_commands();
[[nodiscard]] std::span<const Command> page_commands();
[[nodiscard]] std::span<const Command> export_commands();
[[nodiscard]] std::span<const Command> bench_commands();
///@}

/// Adds a command of commands.def, without options yet, with its line of the help.
CLI::App* add_command(CLI::App& app, std::string_view name);

/// What every program tells of itself and of the others.
///@{
void add_help_command(CLI::App& app, Outcome& outcome);
void add_man_command(CLI::App& app, Outcome& outcome);
void add_version_command(CLI::App& app, Outcome& outcome);
void add_completion_command(CLI::App& app, Outcome& outcome);
void add_describe_command(CLI::App& app, Outcome& outcome);
///@}

}  // namespace coilwright::cli
