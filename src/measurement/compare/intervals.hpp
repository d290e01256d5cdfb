#pragma once

#include <span>
#include <vector>

#include "coilwright/measurement/compare/estimate.hpp"
#include "measurement/compare/fitted_hypothesis.hpp"

namespace coilwright::measurement::compare {

/// Estimates of all parameters of `s`, in its order: calibration with intervals from the slopes, the numbers of effects
/// with profile likelihood (all else fitted anew at each held value), 95 %; magnitudes, which no bound lets fall to
/// zero or below, in their logarithm. `unit`: chi^2 that counts as one. Where a profile passes a better optimum than
/// the fit had found, `s` is moved there first.
[[nodiscard]] std::vector<Estimate> estimates(std::span<const replay::Record> records, Scored& s, double unit);

/// The estimates of effect `i` of `s`, choices included, in the order of its kind's parameters.
[[nodiscard]] std::vector<Estimate> estimates_of_effect(const Scored& s, const std::vector<Estimate>& all,
                                                        std::size_t i);

/// Whether effect `i` can be told from nothing: no number's interval reaches the value at which the effect is absent.
[[nodiscard]] bool excludes_absent(const Scored& s, const std::vector<Estimate>& of_effect, std::size_t i);

}  // namespace coilwright::measurement::compare
