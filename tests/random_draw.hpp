#pragma once

#include <cmath>
#include <random>

// Random numbers from a fixed seed that are the same with every standard library, whose distributions are not.
namespace coilwright::random_draw {

using Generator = std::mt19937_64;

inline double uniform(Generator& random, double lower, double upper) {
  return lower + (upper - lower) * static_cast<double>(random() >> 11) * 0x1p-53;
}
inline double log_uniform(Generator& random, double lower, double upper) {
  return lower * std::pow(upper / lower, uniform(random, 0.0, 1.0));
}
/// `lower` to `upper`, both included.
inline int whole(Generator& random, int lower, int upper) {
  return lower + static_cast<int>(random() % static_cast<unsigned>(upper - lower + 1));
}

}  // namespace coilwright::random_draw
