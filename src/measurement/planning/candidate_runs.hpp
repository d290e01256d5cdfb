#pragma once

#include <string>
#include <vector>

#include "coilwright/actuator/model/model.hpp"
#include "coilwright/measurement/planning/experiment.hpp"

namespace coilwright::measurement::planning {

/// A run that could be recorded next.
struct CandidateRun {
  std::string kind{};   ///< "release", "hot_hold", "turned_base", ...
  std::string input{};  ///< what is done, for people
  std::string why{};    ///< what the run shows
  PlannedRun run{};
};

/// Runs that could be added to an experiment, within the levels that it commands already, recorded as its first motion
/// is: steps, sines, a chirp, a release, a long hold, cycles, a reversed step, and runs on a changed rig (base turned,
/// a weight at the tip, coils open or shorted). Their names are `prefix`, the kind and ".csv". None if the experiment
/// has no motion that is commanded.
[[nodiscard]] std::vector<CandidateRun> candidate_runs(const Experiment& experiment, const actuator::Model& nominal,
                                                       const std::string& prefix);

}  // namespace coilwright::measurement::planning
