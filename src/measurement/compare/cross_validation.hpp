#pragma once

#include <span>

#include "measurement/compare/fitted_hypothesis.hpp"

namespace coilwright::measurement::compare {

/// By how much hypothesis `b` predicts runs that it was not fitted to better than `a`: each fit run is left out in turn
/// (one Gauss-Newton step from the fit to all), and the share of the squared residual above the noise that b removes is
/// taken. NaN for a single run.
[[nodiscard]] double cross_validated_gain(std::span<const replay::Record> records, const Scored& a, const Scored& b);

}  // namespace coilwright::measurement::compare
