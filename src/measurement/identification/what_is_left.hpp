#pragma once

#include <Eigen/Core>
#include <vector>

#include "measurement/identification/discrepancy.hpp"

namespace coilwright::measurement::identification {

/// What may be left of the records beside white noise.
struct WhatIsLeft {
  Discrepancy missing{};  ///< of every series
  Discrepancy colour{};   ///< of noise, in series that may be coloured
  double log_prior{};     ///< natural logarithm of its probability before the records

  [[nodiscard]] const Discrepancy& in(const Series& series) const {
    return colour.length <= series.longest_colour ? colour : missing;
  }
};

/// Where it is looked for.
struct RangeOfWhatIsLeft {
  double shortest{};           ///< correlation length of what a torque can make, in sampling intervals
  double longest{};            ///< of the longest series, in sampling intervals
  double largest_deviation{};  ///< over that of the noise; beyond it nothing is probable
  double longest_colour{};     ///< the largest Series::longest_colour
};

/// A grid over all that may be left. Nothing is missing with a probability of a half; otherwise the discrepancy's
/// deviation over the noise is half-Cauchy, its length log-uniform from two samples, or from the shortest that a torque
/// can make, to a third of the longest series. Noise that may be coloured is white or not, as probable one as the
/// other, and has the variance that is stated in either case: even in the share of it that is coloured.
[[nodiscard]] std::vector<WhatIsLeft> all_that_may_be_left(const RangeOfWhatIsLeft& range);

}  // namespace coilwright::measurement::identification
