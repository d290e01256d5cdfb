#pragma once

#include <span>
#include <string>

#include "coilwright/measurement/whiteness/scaled_residual.hpp"

namespace coilwright::measurement::whiteness {

/// Whether a residual is noise.
struct Adequacy {
  double level{};       ///< rms residual over noise
  double structure{};   ///< statistic of the test for whiteness over its limit; above 1: not white
  std::string where{};  ///< run and scale at which it is worst
  [[nodiscard]] bool noise_only() const { return structure <= 1.0; }
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

}  // namespace coilwright::measurement::whiteness
