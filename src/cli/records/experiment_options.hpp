#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "coilwright/measurement/planning/experiment.hpp"
#include "coilwright/text/input_error.hpp"

namespace coilwright::cli {

/// What every command about an experiment/1 is told of it.
struct ExperimentOptions {
  std::string file{};
  std::vector<std::string> noise{};  ///< "angle_deg=0.3"
  std::uint64_t seed = 1;
};

/// Adds --noise and --seed; how the file is given is the command's own.
void add_noise_and_seed(CLI::App& command, ExperimentOptions& options);

/// The experiment of the file, with the noise of the arguments. Throws InputError.
[[nodiscard]] measurement::planning::Experiment read_experiment(const ExperimentOptions& options);

/// What `work` returns. An experiment that does not fit its rig, or a rig that loses its motion under it, is bad input:
/// InputError of the file, with the reason.
template <class Work>
auto blaming_the_experiment(const ExperimentOptions& options, Work&& work) {
  const auto refuse = [&](const std::exception& reason) {
    return text::InputError({.file = options.file, .rule = reason.what()});
  };
  try {
    return work();
  } catch (const std::invalid_argument& misfit) {
    throw refuse(misfit);
  } catch (const std::runtime_error& lost) {
    throw refuse(lost);
  }
}

}  // namespace coilwright::cli
