#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace coilwright::measurement::whiteness {

/// What a model leaves over of one channel of one run, in units of the noise.
struct ScaledResidual {
  std::string run{};  ///< its file, as `where` names it
  std::vector<double>
      times{};  ///< s, increasing; empty on a bench, whose samples then stand in the order of their places
  std::vector<double> values{};        ///< residual / sigma; finite
  std::vector<std::size_t> starts{0};  ///< first sample of each window, rising from 0; {0} without windows
  bool sigma_given = false;            ///< sigma is known, not estimated from the same record
};

/// Throws std::invalid_argument naming run and rule where sizes do not match or a value is not finite.
void check(std::span<const ScaledResidual> residuals);

}  // namespace coilwright::measurement::whiteness
