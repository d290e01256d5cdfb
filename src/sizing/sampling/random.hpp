#pragma once

#include <random>

namespace coilwright::sizing {

/// Uniform in [0, 1) with 53 bits. Unlike std::uniform_real_distribution it gives the same numbers with every standard
/// library.
[[nodiscard]] inline double uniform(std::mt19937_64& random) {
  return static_cast<double>(random() >> 11) * 0x1p-53;
}

}  // namespace coilwright::sizing
