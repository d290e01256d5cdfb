#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "coilwright/measurement/identification/estimate.hpp"
#include "measurement/identification/fitted_hypothesis.hpp"

namespace coilwright::measurement::identification {

/// A hypothesis and the estimates of all its parameters, in its order.
struct EstimatedHypothesis {
  FittedHypothesis fitted;
  std::vector<Estimate> estimates{};
};

/// The hypothesis, fitted on from where it is with derivatives of there: the search took those with respect to declared
/// and local numbers where it began to converge. As it is if it has no effects.
[[nodiscard]] FittedHypothesis refitted(std::span<const replay::PreparedRun> runs, FittedHypothesis fitted);

/// 95 % intervals of all parameters: of the calibration from the curvature at the optimum, of the numbers of effects
/// from the profile likelihood. If a profile reaches a better optimum than the fit had found, the
/// hypothesis is refitted from there first, and its intervals are those at the better optimum. `progress` is told now
/// and then how many ends are known; it may be called from several threads, one at a time.
[[nodiscard]] EstimatedHypothesis estimated(std::span<const replay::PreparedRun> runs, FittedHypothesis fitted,
                                            double overdispersion,
                                            const std::function<void(const std::string&)>& progress = {});

/// The estimates of one effect, discrete choices included, in the order of its kind's parameters.
[[nodiscard]] std::vector<Estimate> estimates_of_effect(const FittedHypothesis& fitted,
                                                        const std::vector<Estimate>& estimates, std::size_t effect);

}  // namespace coilwright::measurement::identification
