#pragma once

#include <optional>
#include <string>
#include <vector>

#include "coilwright/measurement/data/run.hpp"
#include "coilwright/measurement/planning/input_shape.hpp"
#include "coilwright/measurement/planning/instrument.hpp"

namespace coilwright::measurement::planning {

/// A run that somebody plans to record.
struct PlannedRun {
  /// Name, kind, drive, start, channels, clock, hold and rig. Times, angles, inputs and values are still empty, except
  /// angles and inputs of a bench, which are complete.
  data::Run plan;
  bool validate{};
  InputShape input{};                  ///< of a kind with time
  std::optional<int> only{};           ///< index of the one driven coil, or joint under a torque; nothing: all of them
  std::vector<double> start_angles{};  ///< joint angles from which the finger is released, rad; empty: in equilibrium
  double duration{};                   ///< s
  double rate{};                       ///< samples per second
  double input_rate{};                 ///< samples per second of the input on a clock of its own; 0: on that of the run
};

/// The runs that are planned on one rig.
struct Experiment {
  std::string name{};
  Instruments instruments{};
  std::vector<PlannedRun> runs{};  ///< at least one
};

}  // namespace coilwright::measurement::planning
