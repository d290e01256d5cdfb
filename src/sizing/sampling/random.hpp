#pragma once

#include <random>

namespace coilwright::sizing {

/// Uniform in [0, 1) with 53 bits; unlike std::uniform_real_distribution the same in every standard library.
[[nodiscard]] inline double uniform(std::mt19937_64& random) {
  return static_cast<double>(random() >> 11) * 0x1p-53;
}

}  // namespace coilwright::sizing
