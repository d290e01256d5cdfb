#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "coilwright/actuator/model/model.hpp"
#include "coilwright/measurement/localise/dependence.hpp"
#include "coilwright/simulation/model_input.hpp"
#include "coilwright/simulation/state.hpp"

namespace coilwright::measurement::localise {

/// A measured motion beside the motion of the model under the same input.
struct MeasuredMotion {
  std::string run{};                           ///< its file
  const actuator::Model* model{};              ///< on the rig of this run (data::RigChange); not owned
  simulation::ModelInput input{};              ///< one row per sample
  std::vector<simulation::State> simulated{};  ///< one state of the model per sample
  /// Measured angles, rad, one value per sample: one series per joint, or a single series of their sum (the bending
  /// angle). Offset and scale of the camera have been removed.
  std::vector<std::vector<double>> angles{};
  std::vector<double> sigma{};         ///< noise of each series, rad; > 0
  std::vector<std::size_t> starts{0};  ///< first sample of each window, each with an initial state of its own; from 0
};

/// The residual of a model as a generalised torque along the measured motion.
struct ResidualTorque {
  double rms{};                           ///< N m
  double noise_floor{};                   ///< rms that measurement noise alone would cause, N m
  std::vector<Dependence> dependences{};  ///< strongest first
  std::optional<double> frequency{};      ///< frequency of the strongest spectral line, Hz; nothing if there is none
};

/// The torque that the model lacks in these motions, and the variables on which it depends.
///
/// The difference of measured and simulated angle is smoothed (Whittaker, third differences, Mallows' C_p), so that
/// what the model predicts correctly is not smoothed; the torque is then
/// M (theta''_measured - theta''_model(measured state)).
/// A bending angle alone gives the one torque that, equal in all joints, causes its acceleration; the difference of
/// angles is shared among the joints as such a torque would bend them at rest. Records per joint give one torque per
/// joint, and the names of their dependences say which ("rate of joint 2"); `rms` and `noise_floor` are then taken over
/// all joints. Two smoothing lengths are left out at each end of a window.
///
/// A dependence consists of means in up to 20 bins, computed on every second block of samples and tested on the other
/// blocks, and the reverse. It is kept if it explains more than 2 % there. Dependences are ordered by `explained` minus
/// 0.0025 per bin, so that of two that explain the same the simpler one comes first. `frequency` belongs to the
/// strongest spectral line that exceeds the spectrum around it by more than chance; it is a dependence of its own.
///
/// `rms` is 0 and there are no dependences if no motion is long enough (16 samples).
/// Throws std::invalid_argument naming run and rule if sizes do not match, or a motion has no model.
[[nodiscard]] ResidualTorque residual_torque(std::span<const MeasuredMotion> motions);

}  // namespace coilwright::measurement::localise
