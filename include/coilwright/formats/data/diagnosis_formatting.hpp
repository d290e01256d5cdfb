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

/// The comparison that a reader looks at first (an angle where there is one), then the others as they come.
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

/// How far a declared number has moved, in its tolerances: + where it is larger than declared. Of one that changes
/// nothing where it is: how far it has moved at least.
[[nodiscard]] double tolerances_moved(const measurement::MovedNumber& number);

/// Whether these are the effects that the diagnosis reports, in any order; never for none.
[[nodiscard]] bool is_reported(const measurement::Diagnosis& diagnosis,
                               std::span<const actuator::EffectKind* const> kinds);

/// The hypothesis whose effects the diagnosis reports: that of no effect where it reports none. Null where no
/// hypothesis was compared.
[[nodiscard]] const measurement::identification::WeighedHypothesis* reported_hypothesis(
    const measurement::Diagnosis& diagnosis);

/// Chi-square of the declared model, fitted anew without effects; NaN where no hypothesis was compared.
[[nodiscard]] double chi_square_without_effects(const measurement::Diagnosis& diagnosis);

/// The probability that an effect is there, whatever its further numbers.
[[nodiscard]] double probability_of(const measurement::Diagnosis& diagnosis, const actuator::EffectKind& kind);

/// A quantity as the report calls it: "torque"; "angle" for both kinds of angles, whose errors are taken together.
[[nodiscard]] std::string_view name_of(measurement::data::ChannelKind quantity);

/// The unit of its errors: deg, deg_s, Nmm, N or K.
[[nodiscard]] units::Unit error_unit(measurement::data::ChannelKind quantity);

/// What the report calls a variable on which a residual may depend: {"angle", rad} is written in deg, {"current
/// history", ...} as it is.
[[nodiscard]] units::Unit variable_unit(std::string_view variable);

/// "mae" and deg make "mae_deg"; no unit leaves the name.
[[nodiscard]] std::string with_unit(std::string_view name, const units::Unit& unit);

}  // namespace coilwright::formats
