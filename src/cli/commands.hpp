#pragma once

namespace CLI {
class App;
}

namespace coilwright::cli {

struct Outcome;

/// Adds one command to the program: its options, its help with an example, and what it does, which sets `outcome` when
/// it ends otherwise than well. `outcome` outlives the parsing.
using AddCommand = void (*)(CLI::App& app, Outcome& outcome);

void add_completion_command(CLI::App& app, Outcome& outcome);
void add_crawl_command(CLI::App& app, Outcome& outcome);
void add_diagnose_command(CLI::App& app, Outcome& outcome);
void add_drive_command(CLI::App& app, Outcome& outcome);
void add_evaluate_command(CLI::App& app, Outcome& outcome);
void add_export_command(CLI::App& app, Outcome& outcome);
void add_field_command(CLI::App& app, Outcome& outcome);
void add_force_command(CLI::App& app, Outcome& outcome);
void add_init_command(CLI::App& app, Outcome& outcome);
void add_linearise_command(CLI::App& app, Outcome& outcome);
void add_list_command(CLI::App& app, Outcome& outcome);
void add_man_command(CLI::App& app, Outcome& outcome);
void add_pareto_command(CLI::App& app, Outcome& outcome);
void add_plan_command(CLI::App& app, Outcome& outcome);
void add_reach_command(CLI::App& app, Outcome& outcome);
void add_report_command(CLI::App& app, Outcome& outcome);
void add_help_command(CLI::App& app, Outcome& outcome);
void add_grip_command(CLI::App& app, Outcome& outcome);
void add_rig_command(CLI::App& app, Outcome& outcome);
void add_schema_command(CLI::App& app, Outcome& outcome);
void add_simulate_command(CLI::App& app, Outcome& outcome);
void add_size_command(CLI::App& app, Outcome& outcome);
void add_sweep_command(CLI::App& app, Outcome& outcome);
void add_archive_command(CLI::App& app, Outcome& outcome);
void add_twin_command(CLI::App& app, Outcome& outcome);
void add_validate_command(CLI::App& app, Outcome& outcome);
void add_version_command(CLI::App& app, Outcome& outcome);

}  // namespace coilwright::cli
