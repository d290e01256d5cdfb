#pragma once

#include <cstdint>
#include <random>

namespace truth {

/// Random numbers that are the same on every platform: std::mt19937_64 is portable, the distributions of the standard
/// library are not.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  /// In [0, 1).
  double uniform() { return static_cast<double>(engine_() >> 11) * 0x1.0p-53; }
  double uniform(double lower, double upper) { return lower + (upper - lower) * uniform(); }
  /// Between two positive numbers, uniform in the logarithm.
  double log_uniform(double lower, double upper);
  /// Mean 0, standard deviation 1 (Box and Muller, Ann. Math. Stat. 29, 610, 1958).
  double normal();
  /// 0 to count - 1.
  int below(int count) { return static_cast<int>(uniform() * count); }
  /// -1 or 1.
  double sign() { return uniform() < 0.5 ? -1.0 : 1.0; }
  /// A seed for another generator.
  std::uint64_t seed() { return engine_(); }

 private:
  std::mt19937_64 engine_;
  bool has_spare_ = false;
  double spare_{};
};

}  // namespace truth
