#pragma once

#include <span>
#include <vector>

namespace coilwright::measurement::signals {

/// For each value whether it is a spike: up to three values in a row that lie more than six local standard deviations
/// from the median of their neighbours. The local standard deviation is that of the same differences within 50 values
/// to both sides, by their median, and at least `least`; so neither a slow curve nor a noisy stretch is a spike. The
/// first and the last four have neighbours to one side only, and must lie as far from their straight line, too.
[[nodiscard]] std::vector<char> spikes(std::span<const double> values, double least = 0.0);

/// For each value whether it is far from 0 compared with the others: up to three in a row beyond four standard
/// deviations, which are those of all values by their median, and at least `least`. None where more than the fraction
/// `most` are so far: then the values are not noise with exceptions.
[[nodiscard]] std::vector<char> far_values(std::span<const double> values, double least, double most = 0.1);

/// The values with spikes replaced by straight lines between what is beside them.
[[nodiscard]] std::vector<double> without_spikes(std::vector<double> values);

}  // namespace coilwright::measurement::signals
