#pragma once

#include <span>
#include <string>
#include <vector>

#include "coilwright/measurement/diagnosis.hpp"

namespace coilwright::report {

/// Ids of some kinds of effects.
[[nodiscard]] std::vector<std::string> ids(std::span<const actuator::EffectKind* const> kinds);

/// Whether a hypothesis was weighed by a fit. Without, it was ruled out by its remark alone, and its evidence holds no
/// numbers.
[[nodiscard]] bool weighed(const measurement::Candidate& candidate);

/// The comparison that a reader looks at first (an angle where there is one), then the others as they come.
[[nodiscard]] std::vector<const measurement::ErrorComparison*> main_first(
    std::span<const measurement::ErrorComparison> comparisons);

/// Whether a number of an effect is one of a few choices, each of which was tried: there is no interval about it.
[[nodiscard]] bool is_choice(const actuator::EffectKind& kind, const measurement::Estimate& estimate);

/// An estimate's numbers in the unit of its key.
struct EstimateInUnit {
  double value{}, lower{}, upper{};
};
[[nodiscard]] EstimateInUnit in_unit(const measurement::Estimate& estimate);

}  // namespace coilwright::report
