#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "coilwright/measurement/localise/dependence.hpp"

namespace coilwright::measurement::localise {

/// Samples of a torque in groups of neighbours, numbered from 0; even and odd groups check each other.
struct Blocks {
  std::vector<std::size_t> of{};  ///< block of each sample
};

/// How much of the variance of `torque` (N m) the means in bins of `variable` explain, one value each a sample: bins of
/// equal counts, 20 at most, a bin for each value where there are fewer values. Means from the even blocks are tried on
/// the odd ones and the reverse; `at` and `residual` are of all samples. Explains 0 where the variable has one value.
[[nodiscard]] Dependence binned_dependence(std::string name, std::span<const double> variable,
                                           std::span<const double> torque, const Blocks& blocks);

}  // namespace coilwright::measurement::localise
