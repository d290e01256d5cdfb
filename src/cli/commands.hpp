#pragma once

namespace CLI {
class App;
}

namespace coilwright::cli {

/// How the program ends; the numbers are part of its interface.
enum class ExitCode : int {
  done = 0,
  failure = 1,       ///< anything else
  bad_input = 2,     ///< an input or the usage is wrong, or a place for results cannot be written
  infeasible = 3,    ///< no design keeps all limits; the least infeasible one is written
  interrupted = 130  ///< stopped by a signal; what was found so far is written
};

/// What a command leaves behind.
struct Outcome {
  ExitCode code = ExitCode::done;
};

/// Adds one command to the program: its options, its help with an example, and what it does, which sets `outcome` when
/// it ends otherwise than well. `outcome` outlives the parsing.
using AddCommand = void (*)(CLI::App& app, Outcome& outcome);

void add_completion_command(CLI::App& app, Outcome& outcome);
void add_crawl_command(CLI::App& app, Outcome& outcome);
void add_diagnose_command(CLI::App& app, Outcome& outcome);
void add_distribute_command(CLI::App& app, Outcome& outcome);
void add_drive_command(CLI::App& app, Outcome& outcome);
void add_evaluate_command(CLI::App& app, Outcome& outcome);
void add_export_command(CLI::App& app, Outcome& outcome);
void add_field_command(CLI::App& app, Outcome& outcome);
void add_force_command(CLI::App& app, Outcome& outcome);
void add_init_command(CLI::App& app, Outcome& outcome);
void add_linearise_command(CLI::App& app, Outcome& outcome);
void add_list_command(CLI::App& app, Outcome& outcome);
void add_man_command(CLI::App& app, Outcome& outcome);
void add_merge_command(CLI::App& app, Outcome& outcome);
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
void add_yield_command(CLI::App& app, Outcome& outcome);

/// Each adds one command below `archive`.
void add_archive_list(CLI::App& command);
void add_archive_filter(CLI::App& command);
void add_archive_top(CLI::App& command);
void add_archive_csv(CLI::App& command);
void add_archive_pick(CLI::App& command);
void add_archive_check(CLI::App& command, Outcome& outcome);
/// `outcome` is a failure where a design gives other numbers.
void add_archive_replay(CLI::App& command, Outcome& outcome);

/// Each adds one rig below the command `rig`.
void add_torque_bench(CLI::App& command);
void add_stiffness_gauge(CLI::App& command);
void add_grasp_bench(CLI::App& command);
void add_camera(CLI::App& command);

}  // namespace coilwright::cli
