#pragma once

#include <cstddef>
#include <vector>

#include "sizing/sampling/samples.hpp"

namespace coilwright::sizing {

/// Indices of at most `count` of the `candidates` (unit coordinates; one combination of levels) of which a Gaussian
/// process through the known designs expects the largest gain of the front times the probability that they keep every
/// limit; the gain is that of `Samples::add`, and while nothing is feasible any design within the range of the known
/// ones is one. Each choice is made as if the earlier ones had turned out as expected. Candidates nearer to a failed
/// design than to any other are left out. Empty with fewer than three evaluated designs. Pure.
[[nodiscard]] std::vector<std::size_t> of_most_expected_gain(const Samples& samples,
                                                             const std::vector<std::vector<double>>& candidates,
                                                             std::size_t count);

}  // namespace coilwright::sizing
