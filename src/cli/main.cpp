#include <array>
#include <csignal>

#include "command_line.hpp"
#include "film/film_commands.hpp"

namespace {

// In the order of the help.
constexpr std::array commands = {
    &coilwright::cli::add_evaluate_command,  // the model
    &coilwright::cli::add_simulate_command, &coilwright::cli::add_linearise_command,
    &coilwright::cli::add_reach_command,    &coilwright::cli::add_force_command,
    &coilwright::cli::add_field_command,    &coilwright::cli::add_drive_command,
    &coilwright::cli::add_grip_command,  // the systems
    &coilwright::cli::add_crawl_command,
    &coilwright::cli::add_size_command,  // the search
    &coilwright::cli::add_sweep_command,    &coilwright::cli::add_pareto_command,
    &coilwright::cli::add_yield_command,    &coilwright::cli::add_distribute_command,
    &coilwright::cli::add_merge_command,    &coilwright::cli::add_archive_command,
    &coilwright::cli::add_diagnose_command,  // the measurement
    &coilwright::cli::add_plan_command,     &coilwright::cli::add_twin_command,
    &coilwright::cli::add_rig_command,
    &coilwright::cli::add_tag_command,  // the camera
    &coilwright::cli::add_lens_command,     &coilwright::cli::add_track_command,
    &coilwright::cli::add_report_command,  // what people take away
    &coilwright::cli::add_export_command,
    &coilwright::cli::add_validate_command,  // the proof
    &coilwright::cli::add_list_command,      // the files
    &coilwright::cli::add_init_command,     &coilwright::cli::add_schema_command,
};

}  // namespace

int main(int argc, char** argv) {
  // A file that may grow no further (ulimit -f) is then an error of the writing, told as a full disk is, and no death.
  std::signal(SIGXFSZ, SIG_IGN);
  return static_cast<int>(coilwright::cli::run({argv, static_cast<std::size_t>(argc)}, commands));
}
