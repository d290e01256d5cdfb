#pragma once

#include <span>
#include <vector>

#include "coilwright/measurement/localise/residual_torque.hpp"

namespace coilwright::measurement::localise {

/// The residual torque of one motion at the samples that are far enough from edges, and the motion there.
struct TorqueSeries {
  std::vector<std::size_t> samples;               ///< indices into the motion, rising
  std::vector<std::vector<double>> torque;        ///< N m, per measured series, a value for each of `samples`
  std::vector<std::vector<double>> noise;         ///< the same for a draw of the noise alone
  std::vector<std::vector<double>> angle;         ///< of each measured series, smoothed, rad
  std::vector<std::vector<double>> rate;          ///< rad/s
  std::vector<std::vector<double>> acceleration;  ///< rad/s^2
  std::vector<std::vector<double>> rate_noise;    ///< of the noise alone, rad/s
  double reach{};                                 ///< smoothing length, samples
};

/// `seed`: of the draw. A motion without a stretch of 16 samples has no samples.
[[nodiscard]] TorqueSeries torque_series(const MeasuredMotion& motion, const actuator::Model& model,
                                         unsigned long seed);

}  // namespace coilwright::measurement::localise
