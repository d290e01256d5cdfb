#include "measurement/signals/spectrum.hpp"

#include <cmath>
#include <complex>
#include <numbers>
#include <unsupported/Eigen/FFT>

namespace coilwright::measurement::signals {
namespace {

using Complex = std::complex<double>;

std::vector<Complex> transformed(const std::vector<Complex>& in) {
  Eigen::FFT<double> fft;
  std::vector<Complex> out;
  fft.fwd(out, in);
  return out;
}

}  // namespace

std::vector<double> cosine_energies(std::span<const double> values) {
  const std::size_t n = values.size();
  if (n == 0) return {};
  // The series and its mirror image, twice as long, have a Fourier transform that is the cosine transform turned.
  std::vector<Complex> mirrored(2 * n);
  for (std::size_t i = 0; i < n; ++i) mirrored[i] = mirrored[2 * n - 1 - i] = values[i];
  const std::vector<Complex> lines = transformed(mirrored);
  std::vector<double> energies(n);
  for (std::size_t k = 0; k < n; ++k) {
    const double angle = -std::numbers::pi * static_cast<double>(k) / (2.0 * static_cast<double>(n));
    const double sum = 0.5 * (lines[k] * std::polar(1.0, angle)).real();
    energies[k] = sum * sum * (k == 0 ? 1.0 : 2.0) / static_cast<double>(n);
  }
  return energies;
}

Periodogram periodogram(std::span<const double> values) {
  Periodogram result;
  result.size = 2;
  while (result.size < 2 * values.size()) result.size *= 2;
  std::vector<Complex> padded(result.size);
  for (std::size_t i = 0; i < values.size(); ++i) padded[i] = values[i];
  const std::vector<Complex> lines = transformed(padded);
  for (std::size_t k = 0; k <= result.size / 2; ++k)
    result.power.push_back(std::norm(lines[k]) / static_cast<double>(values.size()));
  return result;
}

}  // namespace coilwright::measurement::signals
