#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "coilwright/measurement/localise/dependence.hpp"

namespace coilwright::measurement::localise {

/// Samples of a torque in blocks of neighbours, numbered from 0: what is fitted to even blocks is tested on odd ones,
/// and the reverse.
struct SampleBlocks {
  std::vector<std::size_t> number{};  ///< number of the block of each sample
};

/// How much of the variance of `torque` (N m) the means in bins of `variable` explain; both have one value per sample.
/// There are up to 20 bins of equal counts, or one bin per value if there are fewer values. Means from even blocks are
/// tested on odd ones, and the reverse; `at` and `residual` are taken over all samples. Explains 0 if the variable has
/// a single value.
[[nodiscard]] Dependence binned_dependence(std::string name, std::span<const double> variable,
                                           std::span<const double> torque, const SampleBlocks& blocks);

}  // namespace coilwright::measurement::localise
