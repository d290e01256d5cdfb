#pragma once

#include <string>

#include "coilwright/measurement/data/run.hpp"

namespace coilwright::measurement::noise {

/// The noise of one channel of a run.
struct NoiseLevel {
  std::string run{};
  std::string channel{};
  double sigma{};        ///< SI
  bool given{};          ///< by the set, not estimated
  std::string source{};  ///< "given", or how it was estimated
};

/// The standard deviation of the measurement noise in one channel of a run, SI, always > 0.
///
/// A `sigma` that the run gives is taken as it is. Otherwise the noise is estimated from the record itself: it is what
/// local polynomials leave over, where the motion is smooth beside the sampling and the noise is white. The widest
/// window is used that the motion does not enter yet, and a trimmed scale keeps onsets and impacts out. Sampling may be
/// uneven. Never below the quantisation's own resolution / sqrt(12), resolution being the smallest step between two
/// distinct values. A bench without time is judged over its angles at equal current (or the reverse).
/// Relative standard error 1 / sqrt(2 n) for n samples and a little more; `source` states it, in one line, and says so
/// where the record is too short for an estimate. Source: docs/theory/measurement.md.
/// Throws std::invalid_argument where the channel's number of values is not the run's.
[[nodiscard]] NoiseLevel noise_of(const data::Run& run, const data::Channel& channel);

}  // namespace coilwright::measurement::noise
