#pragma once

#include <span>
#include <vector>

namespace coilwright::measurement::noise {

/// Squared coefficients of the orthonormal cosine transform (DCT-II), as many as values: those of white noise of
/// variance s^2 are independent, each s^2 times a chi-square of one degree of freedom. Coefficient k has k / (2 n)
/// turns a sample.
[[nodiscard]] std::vector<double> cosine_energies(std::span<const double> values);

/// |sum of v_j exp(-2 pi i f j)|^2 / n at f = k / size turns a sample.
struct Periodogram {
  std::vector<double> power;  ///< k = 0 .. size / 2; of white noise of variance s^2: mean s^2, exponential
  std::size_t size{};         ///< the transform's length, a power of two from two to four times the number of values
};
[[nodiscard]] Periodogram periodogram(std::span<const double> values);

}  // namespace coilwright::measurement::noise
