#pragma once

#include <span>
#include <vector>

#include "coilwright/measurement/localise/residual_torque.hpp"

namespace coilwright::measurement::localise {

/// The residual torque of one motion at the samples that are far enough from the ends of windows, and the motion there.
struct TorqueSeries {
  std::vector<std::size_t> samples;               ///< indices into the motion, increasing
  std::vector<std::vector<double>> torque;        ///< N m, for each measured series one value per sample
  std::vector<std::vector<double>> noise;         ///< the same for a random draw of the noise alone
  std::vector<std::vector<double>> angle;         ///< of each measured series, smoothed, rad
  std::vector<std::vector<double>> rate;          ///< rad/s
  std::vector<std::vector<double>> acceleration;  ///< rad/s^2
  std::vector<std::vector<double>> rate_noise;    ///< of that draw alone, rad/s
  double smoothing_length{};                      ///< samples
};

/// The torque that the model lacks, by inverse dynamics of the measured motion. `seed`: random seed of the draw of the
/// noise. The result has no samples if no window of the motion has 16.
[[nodiscard]] TorqueSeries residual_torque_series(const MeasuredMotion& motion, unsigned long seed);

}  // namespace coilwright::measurement::localise
