#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "coilwright/measurement/diagnosis.hpp"

namespace coilwright::formats {

/// Ids of some kinds of effects.
[[nodiscard]] std::vector<std::string> ids(std::span<const actuator::EffectKind* const> kinds);

/// The comparison that a reader looks at first (an angle where there is one), then the others as they come.
[[nodiscard]] std::vector<const measurement::ErrorComparison*> main_first(
    std::span<const measurement::ErrorComparison> comparisons);

/// The part of an estimate's name whose end is its unit: "/magnetics/0/torque_Nmm_A" of a pointer to one number of that
/// list, otherwise the whole name.
[[nodiscard]] std::string_view key_with_unit(std::string_view name);

/// An estimate's numbers in the unit of its key.
struct EstimateInUnit {
  double value{}, lower{}, upper{};
};
[[nodiscard]] EstimateInUnit in_unit(const measurement::compare::Estimate& estimate);

}  // namespace coilwright::formats
