#pragma once

#include <string>
#include <vector>

#include "coilwright/measurement/data/run.hpp"
#include "coilwright/measurement/planning/experiment.hpp"

namespace coilwright::measurement::planning {

/// One channel of a proposed run, as each explanation that is left has it and perfect instruments would show it.
struct ExpectedReading {
  std::string run{};         ///< name of the planned run
  std::string channel{};     ///< name of its column: "bending_angle_deg"
  data::ChannelKind kind{};  ///< what it measures
  double noise{};            ///< standard deviation of one reading, SI; 0 if it is not known
  std::vector<double> at{};  ///< s; on a torque bench rad
  std::vector<std::vector<double>>
      values{};  ///< SI; of each of NextExperiment::explanations one value for each of `at`
};

/// The run that is expected to leave least open which explanation is true, where the present data cannot tell.
struct NextExperiment {
  std::string kind{};   ///< one of the candidate runs, "release", "hot_hold", ..., or "bench_torque"
  std::string input{};  ///< the command, with numbers
  std::string why{};
  double open_bits{};       ///< between the explanations, by their probabilities
  double remaining_bits{};  ///< of these, at most, on average over what the run may show
  /// All that is to be recorded, with the camera, clocks and noise of the present records: the motions that an
  /// experiment can repeat, ten seconds at rest, and at the end the proposed run, twice: an effect is credited only if
  /// it helps in runs that were left out of the fit.
  Experiment experiment{};
  /// Ids of the effects of each explanation that is left: that of the diagnosis first, then its rivals.
  std::vector<std::vector<std::string>> explanations{};
  /// Of each channel of the proposed run (of both runs of a torque bench); none where an explanation cannot be
  /// simulated there.
  std::vector<ExpectedReading> expected{};
};

}  // namespace coilwright::measurement::planning
