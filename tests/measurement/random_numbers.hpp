#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

namespace coilwright::measurement {

/// Normal deviates by Box and Muller on the Mersenne twister: unlike std::normal_distribution the same in every
/// standard library.
class Normal {
 public:
  explicit Normal(std::uint64_t seed) : engine_(seed) {}
  double operator()() {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
    return radius * std::cos(2.0 * std::numbers::pi * uniform());
  }
  /// In [0, 1).
  double uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

 private:
  std::mt19937_64 engine_;
};

inline std::vector<double> normal_deviates(int count, std::uint64_t seed) {
  Normal normal(seed);
  std::vector<double> values;
  for (int i = 0; i < count; ++i) values.push_back(normal());
  return values;
}

}  // namespace coilwright::measurement
