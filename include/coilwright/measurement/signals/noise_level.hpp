#pragma once

#include <cmath>
#include <limits>
#include <string>

#include "coilwright/measurement/data/run.hpp"

namespace coilwright::measurement::signals {

/// The noise of one channel of a run.
struct NoiseLevel {
  std::string run{};
  std::string channel{};
  double sigma{};       ///< standard deviation, SI; > 0
  double resolution{};  ///< smallest step between two distinct values of the record; 0: they are all the same
  bool given{};         ///< whether the set gives it; otherwise it is estimated
  bool from_the_run{};  ///< whether it was estimated from the run itself, not from a record of still instruments
  bool pooled{};        ///< whether other runs of the same instrument tell more of it than the run itself
  double freedom = std::numeric_limits<double>::infinity();  ///< degrees of freedom of its square; infinite if given
  std::string source{};                                      ///< "given", or how it was estimated
  /// The least that the noise can be: resolution / sqrt(12).
  [[nodiscard]] double of_rounding() const { return resolution / std::sqrt(12.0); }
  std::string colour{};   ///< what is assumed of its spectrum, and from where: "white: nothing shows its colour"
  bool colour_unknown{};  ///< whether no record of it at rest has told its spectrum
};

/// The standard deviation of the measurement noise in one channel of a run.
///
/// A `sigma` that the run gives is taken as it is. Otherwise the noise is estimated from the record itself: it is the
/// residual of local polynomial fits, under the assumption that the motion is smooth on the scale of the sampling
/// interval and that the noise is white. The widest window is used whose residual does not contain motion yet, and a
/// trimmed scale excludes onsets and impacts. Sampling may be uneven. The estimate is never below the quantisation
/// noise, resolution / sqrt(12), where the resolution is the smallest step between two distinct values. A bench without
/// time is treated as curves over the angle at equal current, or over the current at equal angle.
/// The relative standard error is somewhat above 1 / sqrt(2 n) for n samples; `source` states it in one line, and says
/// so if the record is too short for an estimate. Source: docs/theory/measurement.md.
/// Throws std::invalid_argument if the channel's number of values is not the run's.
[[nodiscard]] NoiseLevel noise_of(const data::Run& run, const data::Channel& channel);

}  // namespace coilwright::measurement::signals
