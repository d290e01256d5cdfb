#pragma once

#include <functional>
#include <string>
#include <vector>

#include "coilwright/actuator/model/model.hpp"

namespace coilwright::measurement::experiment {

/// The range in which a rig was driven, from its runs: a new experiment does not exceed it.
struct DriveRange {
  bool coils{};        ///< whether currents drive the rig; otherwise a torque at the first joint
  double amplitude{};  ///< largest current, A, or largest torque, N m
  double interval{};   ///< s between samples
  double sigma{};      ///< noise of the first angle channel, rad
  std::string unit{};  ///< of the amplitude, for people
};

/// A run that could be recorded next.
struct CandidateExperiment {
  std::string kind{};
  std::string input{};                                         ///< the command, for people
  std::string why{};                                           ///< what the run shows
  double duration{};                                           ///< s
  std::function<double(double)> command{};                     ///< command over the amplitude at a time in s
  std::function<void(actuator::ModelSpec&)> change = nullptr;  ///< what is changed on the rig; may be empty
};

/// Steps, sines, a chirp, a release, holds, cycles, a reversed current, a turned base and, for coils, an open circuit.
[[nodiscard]] std::vector<CandidateExperiment> candidate_experiments(const DriveRange& range);

}  // namespace coilwright::measurement::experiment
