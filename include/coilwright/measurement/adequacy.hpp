#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "coilwright/measurement/diagnosis.hpp"

namespace coilwright::measurement {

/// What a model leaves over of one channel of one run, in units of the noise.
struct ScaledResidual {
  std::string run{};  ///< its file, as `where` names it
  std::vector<double>
      times{};  ///< s, increasing; empty on a bench, whose samples then stand in the order of their places
  std::vector<double> values{};        ///< residual / sigma; finite
  std::vector<std::size_t> starts{0};  ///< first sample of each window, rising from 0; {0} without windows
  bool sigma_given = false;            ///< sigma is known, not estimated from the same record
};

/// Whether residuals are noise: white at every scale, alone and taken together.
///
/// `level` is the root mean square, with `fitted_parameters` taken off the count of samples. `structure` is the worst
/// of four kinds of tests, each as excess over its expectation by the excess allowed: energy at all wavelengths longer
/// than 2, 4, 8, ... samples, of single runs and of all together; lines of the spectrum, likewise; means of blocks of
/// 8, 16, ... samples. The measure of each run is its own level at high frequencies (at least 1 where sigma was given,
/// or the run is shorter than 64 samples), so that an error of the estimated sigma is no structure. Limits are such
/// that white noise is above 1 in fewer than 1 of 200 sets, whatever their size. Structure of rms up to 0.03 of the
/// noise is allowed on top, which moves an rms error by 0.05 %. Runs of fewer than 4 samples count for the level alone.
/// Rules, power and sources: docs/theory/measurement.md.
/// Throws std::invalid_argument naming run and rule where sizes do not match or a value is not finite.
[[nodiscard]] Adequacy adequacy_of(std::span<const ScaledResidual> residuals, int fitted_parameters);

/// How many samples of the residuals count as one: the integrated autocorrelation time 1 + 2 sum rho(t) about zero
/// mean, in samples, >= 1, summed up to the first lag that is five times the sum so far (Sokal's window). Products
/// across the start of a window do not count. 1 for white noise; throws as `adequacy_of` does.
[[nodiscard]] double correlation_time(std::span<const ScaledResidual> residuals);

}  // namespace coilwright::measurement
