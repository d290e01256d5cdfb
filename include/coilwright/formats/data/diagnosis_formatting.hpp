#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "coilwright/measurement/data/run.hpp"
#include "coilwright/measurement/diagnosis.hpp"
#include "coilwright/units/unit.hpp"

namespace coilwright::formats {

/// Ids of some kinds of effects.
[[nodiscard]] std::vector<std::string> ids(std::span<const actuator::EffectKind* const> kinds);

/// The comparisons of errors: the main one first (an angle if there is one), then the others in their order.
[[nodiscard]] std::vector<const measurement::ErrorComparison*> main_first(
    std::span<const measurement::ErrorComparison> comparisons);

/// An estimate's numbers in the unit of its key.
struct EstimateInUnit {
  double value{}, lower{}, upper{};
  std::optional<double> declared{};
};
[[nodiscard]] EstimateInUnit in_unit(const measurement::identification::Estimate& estimate);

/// A declared number that a fit moved, in the unit of its key.
struct MovedNumberInUnit {
  double declared{}, tolerance{};
  std::optional<double> idle_from{};
};
[[nodiscard]] MovedNumberInUnit in_unit(const measurement::MovedNumber& number);

/// Distance by which a declared number has moved, in its tolerances; positive if it is larger than declared. For a
/// number that changes nothing at its value it is the least distance.
[[nodiscard]] double tolerances_moved(const measurement::MovedNumber& number);

/// Whether the diagnosis reports exactly these effects, in any order; false for none.
[[nodiscard]] bool is_reported(const measurement::Diagnosis& diagnosis,
                               std::span<const actuator::EffectKind* const> kinds);

/// The hypothesis whose effects the diagnosis reports, or that of no effect if it reports none. Null if no hypothesis
/// was compared.
[[nodiscard]] const measurement::identification::WeighedHypothesis* reported_hypothesis(
    const measurement::Diagnosis& diagnosis);

/// Chi-square of the declared model, fitted anew without effects; NaN if no hypothesis was compared.
[[nodiscard]] double chi_square_without_effects(const measurement::Diagnosis& diagnosis);

/// The probability that an effect is there, whatever its further numbers.
[[nodiscard]] double probability_of(const measurement::Diagnosis& diagnosis, const actuator::EffectKind& kind);

/// The name of a quantity in the report: "torque"; "angle" for both kinds of angles, whose errors are taken together.
[[nodiscard]] std::string_view name_of(measurement::data::ChannelKind quantity);

/// The unit of the quantity's errors: deg, deg_s, Nmm, N or K.
[[nodiscard]] units::Unit error_unit(measurement::data::ChannelKind quantity);

/// The unit in which the report states a variable on which a residual may depend: deg for "angle"; none for "current
/// history".
[[nodiscard]] units::Unit variable_unit(std::string_view variable);

/// Appends the unit to a name: "mae" and deg make "mae_deg"; no unit leaves the name.
[[nodiscard]] std::string with_unit(std::string_view name, const units::Unit& unit);

}  // namespace coilwright::formats
