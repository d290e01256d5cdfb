#include "cli/records/experiment_options.hpp"

#include "cli/options.hpp"
#include "coilwright/formats/data/experiment_file.hpp"

namespace coilwright::cli {

void add_noise_and_seed(CLI::App& command, ExperimentOptions& options) {
  command
      .add_option(
          "--noise", options.noise,
          "QUANTITY=VALUE: standard deviation of the noise of one instrument, for example angle_deg=0.3; overrides the "
          "experiment's; may be repeated")
      ->allow_extra_args(false);
  add_seed_option(command, options.seed, "Random seed for the noise (default 1)");
}

measurement::planning::Experiment read_experiment(const ExperimentOptions& options) {
  measurement::planning::Experiment experiment = formats::read_experiment(options.file);
  require_names_once(options.noise);
  for (const std::string& argument : options.noise) formats::set_noise(experiment.instruments, argument);
  return experiment;
}

}  // namespace coilwright::cli
