#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "coilwright/actuator/model.hpp"
#include "coilwright/measurement/localise/dependence.hpp"
#include "coilwright/simulation/model_input.hpp"
#include "coilwright/simulation/state.hpp"

namespace coilwright::measurement::localise {

/// A motion as it was measured, beside what the model makes of the same input.
struct MeasuredMotion {
  std::string run{};                           ///< its file
  simulation::ModelInput input{};              ///< a row a sample
  std::vector<simulation::State> simulated{};  ///< of the model, a state a sample
  /// Measured, rad, a value a sample: one series per joint, or a single one, their sum (the bending angle). Delay,
  /// offset and scale of the camera are taken off before.
  std::vector<std::vector<double>> angles{};
  std::vector<double> sigma{};         ///< noise of each series, rad; > 0
  std::vector<std::size_t> starts{0};  ///< first sample of each window in which `simulated` starts anew, from 0
};

/// What is left over by the model, as a generalised torque over the measured motion.
struct ResidualTorque {
  double rms{};                           ///< N m
  double smallest_visible{};              ///< what noise alone gives, N m
  std::vector<Dependence> dependences{};  ///< strongest first
  std::optional<double> frequency{};      ///< of the strongest line in its spectrum, Hz
};

/// What `model` lacks in these motions, as a torque over the measured motion, and on what that depends.
///
/// The difference of measured and simulated angle is smoothed (Whittaker, third differences, Mallows' C_p), so that
/// what the model has right passes unsmoothed; the torque is then M (theta''_measured - theta''_model(measured state)).
/// A bending angle alone gives the one torque that, the same in all joints, moves it so; the difference is shared among
/// the joints as such a torque would bend them at rest. Records per joint give a torque per joint, and the names of
/// their dependences say which ("rate of joint 2"); `rms` and `smallest_visible` are then over all joints together.
/// Edges of windows are left out, two smoothing lengths at each.
///
/// A dependence is made of means in up to 20 bins on every second block of samples and tried on the others, and the
/// reverse; kept if it explains more than 2 % there. They are in order of `explained` less 0.0025 a bin, so that the
/// simpler of two that say the same stands first. `frequency` is of the strongest line that stands out of the spectrum
/// around it by more than chance, and is a dependence of its own.
///
/// `rms` is 0 and nothing depends on anything where no motion is long enough (16 samples).
/// Throws std::invalid_argument naming run and rule where sizes do not fit.
[[nodiscard]] ResidualTorque residual_torque(std::span<const MeasuredMotion> motions, const actuator::Model& model);

}  // namespace coilwright::measurement::localise
