#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "coilwright/measurement/localise/residual_torque.hpp"
#include "measurement/localise/binned_dependence.hpp"
#include "measurement/localise/inverse_dynamics.hpp"

namespace coilwright::measurement::localise {

/// One measured series of all motions, end to end. Refers to the motions.
struct PooledSeries {
  std::vector<double> torque, noise, angle, rate, rate_noise, acceleration;  ///< as TorqueSeries has them
  std::vector<double> time;                                                  ///< s since the first sample of the run
  std::vector<double> run;                                                   ///< number of the motion, from 1
  std::vector<const MeasuredMotion*> motion;                                 ///< of each sample
  std::vector<std::size_t> sample;                                           ///< index of each sample in its motion
};
[[nodiscard]] PooledSeries pooled(std::span<const MeasuredMotion> motions, const std::vector<TorqueSeries>& all,
                                  std::size_t series);

/// Blocks of samples that are longer than the smoother's reach, so that even and odd blocks have independent noise.
/// `smoothing_length` in samples.
[[nodiscard]] SampleBlocks blocks_of(const PooledSeries& samples, double smoothing_length);

[[nodiscard]] double mean_square(std::span<const double> values);

}  // namespace coilwright::measurement::localise
