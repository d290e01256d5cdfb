#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace coilwright::measurement::whiteness {

/// The residual of a model in one channel of one run, in units of the noise.
struct ScaledResidual {
  std::string run{};                   ///< its file, as WhitenessResult::where names it
  std::vector<double> times{};         ///< s, increasing; empty on a bench, whose samples are in the order of the file
  std::vector<double> values{};        ///< residual / sigma; finite
  std::vector<std::size_t> starts{0};  ///< first sample of each window, increasing from 0; {0} without windows
  bool sigma_given = false;            ///< whether sigma is known; otherwise it was estimated from the same record
};

/// Throws std::invalid_argument naming run and rule if sizes do not match or a value is not finite.
void validate_residuals(std::span<const ScaledResidual> residuals);

}  // namespace coilwright::measurement::whiteness
