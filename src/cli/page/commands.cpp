#include "cli/page/commands.hpp"

#include <array>

#include "cli/model/evaluate_command.hpp"
#include "cli/page/page_output.hpp"

namespace coilwright::cli {

std::span<const Command> page_commands() {
  static constexpr std::array commands{
      Command{"report", &add_report_command},
      Command{"validate", &add_validate_command},
      Command{"evaluate", [](CLI::App& app, Outcome& outcome) { add_evaluate(app, outcome, &write_evaluation_page); }},
  };
  return commands;
}

}  // namespace coilwright::cli
