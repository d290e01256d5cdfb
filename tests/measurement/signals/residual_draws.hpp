#pragma once

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "coilwright/measurement/signals/scaled_residual.hpp"
#include "measurement/random_numbers.hpp"

namespace coilwright::measurement::signals {

inline constexpr double interval = 0.002;

inline ScaledResidual white(int samples, Normal& normal, const std::string& run = "run.csv") {
  ScaledResidual residual{.run = run};
  for (int i = 0; i < samples; ++i) {
    residual.times.push_back(interval * i);
    residual.values.push_back(normal());
  }
  return residual;
}

inline std::vector<ScaledResidual> white_set(int runs, int samples, Normal& normal) {
  std::vector<ScaledResidual> set;
  for (int r = 0; r < runs; ++r) set.push_back(white(samples, normal, "run" + std::to_string(r) + ".csv"));
  return set;
}

// Gauss-Markov structure of rms 1 whose correlation falls to 1/e over `samples`.
inline std::vector<double> markov(std::size_t count, double samples, Normal& normal) {
  const double keep = std::exp(-1.0 / samples);
  std::vector<double> values{normal()};
  while (values.size() < count) values.push_back(keep * values.back() + std::sqrt(1.0 - keep * keep) * normal());
  return values;
}

}  // namespace coilwright::measurement::signals
