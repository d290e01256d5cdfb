#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "coilwright/measurement/signals/scaled_residual.hpp"

namespace coilwright::measurement::signals {

/// Structure with an rms of this fraction of the noise is allowed: discretisation, interpolation and jitter of the
/// clock cause it, no effect explains it, and it does not matter.
inline constexpr double allowed_structure = 0.03;

/// The level of a residual at high frequencies counts as its noise up to this factor over sigma: where sigma is known,
/// and where the record itself told it. What is above is structure, whatever its spectrum.
inline constexpr double largest_level_known = 1.03;
inline constexpr double largest_level_estimated = 1.3;

/// A residual divided by its own level at high frequencies, as far as that can be noise. Refers to the residual.
struct NormalisedRun {
  const ScaledResidual* residual{};
  std::vector<double> energies{};  ///< of the cosine transform, over the noise variance
  double noise_variance = 1.0;     ///< variance that counts as noise, in units of sigma^2
  double allowed_energy{};         ///< energy of the structure that is allowed, over the noise variance
  double interval = 1.0;           ///< s between samples; 1 on a bench

  [[nodiscard]] std::size_t samples() const { return residual->values.size(); }
  /// Degrees of freedom of the noise's level at the first `count` coefficients.
  [[nodiscard]] double freedom_of_lowest(std::size_t count) const;
  /// Whether it is long enough for tests at many scales.
  [[nodiscard]] bool is_long() const;
  [[nodiscard]] bool has_times() const { return !residual->times.empty(); }
};

[[nodiscard]] NormalisedRun normalised(const ScaledResidual& residual);

/// The length of so many samples, for people: "16 ms", or "12 samples" on a bench.
[[nodiscard]] std::string length_text(const NormalisedRun& run, std::size_t samples);

}  // namespace coilwright::measurement::signals
