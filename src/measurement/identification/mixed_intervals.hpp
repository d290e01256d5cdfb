#pragma once

#include <vector>

#include "coilwright/measurement/identification/estimate.hpp"
#include "measurement/identification/attribution.hpp"

namespace coilwright::measurement::identification {

/// Widens the intervals of the numbers of the reported hypothesis to those of the whole posterior: a number's variance
/// about the value that is reported is the mean over all hypotheses that have it, by their probabilities, of their own
/// variance and the square of how far they put it (Burnham and Anderson, Model Selection and Multimodel Inference,
/// 2002, section 4.3). A number of an effect is in those with this effect, with as many numbers. So an interval widens
/// where a rival is alive, and where what the reported hypothesis lacks would draw its numbers. `estimates` are those
/// of estimated(), whose values stay.
void widen_by_posterior(std::vector<Estimate>& estimates, const Attribution& attribution, double overdispersion);

}  // namespace coilwright::measurement::identification
