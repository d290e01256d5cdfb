#pragma once

#include <span>
#include <string>

#include "coilwright/measurement/signals/scaled_residual.hpp"

namespace coilwright::measurement::signals {

/// Whether a residual is white noise.
struct WhitenessResult {
  double level{};       ///< rms residual over the noise
  double structure{};   ///< statistic of the worst test over its limit; above 1 the residual is not white
  std::string where{};  ///< run and scale of that test
  /// Whether no test finds structure.
  [[nodiscard]] bool is_white() const { return structure <= 1.0; }
};

/// Tests whether residuals are white noise at every scale, each run alone and all runs pooled.
///
/// `level` is the root mean square, with `fitted_parameters` subtracted from the number of samples. `structure`
/// is the largest result of four kinds of tests, each expressed as the excess over the expectation divided by the
/// excess that is allowed: energy at all wavelengths longer than 2, 4, 8, ... samples, of single runs and pooled over
/// all; spectral lines, likewise; means of blocks of 8, 16, ... samples. Each run is normalised by its own level at
/// high frequencies (at least 1 if sigma was given or the run is shorter than 64 samples), so that an error of the
/// estimated sigma does not count as structure. The limits are such that white noise exceeds 1 in fewer than 1 of 200
/// sets, whatever their size. Structure with an rms of up to 0.03 of the noise, which changes an rms error by 0.05 %,
/// is allowed in addition. Runs of fewer than 4 samples contribute to the level only. Rules, power and sources:
/// docs/theory/measurement.md. Throws std::invalid_argument naming run and rule if sizes do not match or a value is not
/// finite.
[[nodiscard]] WhitenessResult whiteness_test(std::span<const ScaledResidual> residuals, int fitted_parameters);

}  // namespace coilwright::measurement::signals
