#pragma once

#include <string>

#include "coilwright/measurement/experiment/experiment.hpp"

namespace coilwright::measurement::experiment {

/// A run that would separate hypotheses that the present data cannot separate.
struct NextExperiment {
  std::string kind{};   ///< one of the candidate runs, "release", "hot_hold", ..., or "bench_torque"
  std::string input{};  ///< the command, with numbers
  std::string why{};
  double separation{};  ///< rms difference of the hypotheses' predictions over the noise
  /// All that is to be recorded, with the camera, clocks and noise of the present records: the motions that an
  /// experiment can repeat, ten seconds at rest, and at the end the proposed run, twice: an effect is credited only if
  /// it helps in runs that were left out of the fit.
  Experiment experiment{};
};

}  // namespace coilwright::measurement::experiment
