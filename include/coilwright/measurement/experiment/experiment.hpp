#pragma once

#include <optional>
#include <string>
#include <vector>

#include "coilwright/measurement/data/run.hpp"
#include "coilwright/measurement/experiment/input_shape.hpp"
#include "coilwright/measurement/experiment/instrument.hpp"

namespace coilwright::measurement::experiment {

/// A run that somebody plans.
struct PlannedRun {
  /// Name, kind, drive, start and channels; times, angles, inputs and values are still empty, except those of a bench
  /// (angles, inputs), which are complete.
  data::Run plan;
  bool validate{};
  InputShape input{};                  ///< of a kind with time
  std::optional<int> only{};           ///< the one coil (joint, under a torque) that is driven, from 0; nothing: all
  std::vector<double> start_angles{};  ///< rad, a joint; where it is let go. Empty: in equilibrium
  double duration{};                   ///< s
  double rate{};                       ///< samples a second
};

/// What is to be done on a rig.
struct Experiment {
  std::string name{};
  Instruments instruments{};
  std::vector<PlannedRun> runs{};  ///< at least one
};

}  // namespace coilwright::measurement::experiment
