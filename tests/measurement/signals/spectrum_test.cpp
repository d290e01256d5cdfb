#include "measurement/signals/spectrum.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "measurement/random_numbers.hpp"

namespace coilwright::measurement::signals {
namespace {

using std::numbers::pi;

TEST(Spectrum, CosineEnergiesAreTheDirectSums) {
  for (const int n : {1, 2, 5, 64, 97}) {
    const std::vector<double> values = normal_deviates(n, n);
    const std::vector<double> energies = cosine_energies(values);
    ASSERT_EQ(energies.size(), values.size());
    double sum = 0.0;
    double squares = 0.0;
    for (int k = 0; k < n; ++k) {
      double direct = 0.0;
      for (int i = 0; i < n; ++i) direct += values[i] * std::cos(pi * k * (i + 0.5) / n);
      direct *= std::sqrt((k == 0 ? 1.0 : 2.0) / n);
      EXPECT_NEAR(energies[k], direct * direct, 1e-10 * n) << n << " " << k;
      sum += energies[k];
      squares += values[k] * values[k];
    }
    EXPECT_NEAR(sum, squares, 1e-10 * n);  // orthonormal
  }
}

TEST(Spectrum, PeriodogramIsTheDirectSum) {
  const std::vector<double> values = normal_deviates(50, 3);
  const Periodogram lines = periodogram(values);
  EXPECT_EQ(lines.size, 128u);
  ASSERT_EQ(lines.power.size(), 65u);
  for (std::size_t k = 0; k < lines.power.size(); ++k) {
    std::complex<double> sum;
    for (std::size_t i = 0; i < values.size(); ++i)
      sum += values[i] * std::polar(1.0, -2.0 * pi * static_cast<double>(k * i) / 128.0);
    EXPECT_NEAR(lines.power[k], std::norm(sum) / 50.0, 1e-10);
  }
}

}  // namespace
}  // namespace coilwright::measurement::signals
