#pragma once

#include <span>
#include <vector>

#include "coilwright/measurement/identification/estimate.hpp"
#include "coilwright/measurement/identification/hinted_effect.hpp"
#include "measurement/identification/attribution.hpp"

namespace coilwright::measurement::identification {

/// Widens the intervals of all numbers of the reported hypothesis by what one more effect would do to them that these
/// data hint at and do not decide: the estimates hold if nothing else is missing, and nobody knows that. The model that
/// is reported and those with one effect more are averaged with their weights by the quasi-BIC; the variance is that of
/// all of them about the value that is reported (Burnham and Anderson, Model Selection and Multimodel Inference, 2002,
/// section 4.3). Of each kind that guess counts that promises the largest fall of chi-square, where this is more than
/// chance has it (3.84), to first order in its strength, at most SearchEffort::strongest_start times the guess. What
/// the data cannot show at all is not in it: that is among the assumptions. `estimates` are those of estimated(); the
/// values stay, and the further variance adds to that of an interval on both sides. Does nothing where it leaves far
/// more than noise. Returns the effects that widen an interval by a fifth or more, the one that widens most first.
std::vector<HintedEffect> widen_by_unseen_effects(std::vector<Estimate>& estimates,
                                                  std::span<const replay::PreparedRun> runs,
                                                  const Attribution& attribution, double overdispersion);

}  // namespace coilwright::measurement::identification
