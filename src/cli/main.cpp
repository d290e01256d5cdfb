#include <malloc.h>
#include <sys/resource.h>

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

// By default each thread of glibc's reserves 64 MB of addresses for its heap. Where that is not to be had, every
// allocation of the thread is a page of its own from the system: 240 s for the work of 4. One heap for all threads
// takes what there is, and fails where there is no more.
void share_heap_where_addresses_are_few() {
#ifdef M_ARENA_MAX
  rlimit addresses{};
  if (getrlimit(RLIMIT_AS, &addresses) == 0 && addresses.rlim_cur != RLIM_INFINITY) mallopt(M_ARENA_MAX, 1);
#endif
}

}  // namespace

int main(int argc, char** argv) {
  // A file that may grow no further (ulimit -f) is then an error of the writing, told as a full disk is, and no death.
  std::signal(SIGXFSZ, SIG_IGN);
  share_heap_where_addresses_are_few();
  return static_cast<int>(coilwright::cli::run({argv, static_cast<std::size_t>(argc)}, commands));
}
