#pragma once

#include <span>
#include <vector>

namespace coilwright::measurement::signals {

/// Squared coefficients of the orthonormal cosine transform (DCT-II), as many as values: those of white noise of
/// variance s^2 are independent, each s^2 times a chi-square of one degree of freedom. Coefficient k has the frequency
/// k / (2 n) cycles per sample.
[[nodiscard]] std::vector<double> cosine_energies(std::span<const double> values);

/// |sum of v_j exp(-2 pi i f j)|^2 / n at the frequency f = k / size, in cycles per sample.
struct Periodogram {
  std::vector<double>
      power;           ///< k = 0 .. size / 2; for white noise of variance s^2 exponentially distributed with mean s^2
  std::size_t size{};  ///< the transform's length, a power of two from two to four times the number of values
};
[[nodiscard]] Periodogram periodogram(std::span<const double> values);

}  // namespace coilwright::measurement::signals
