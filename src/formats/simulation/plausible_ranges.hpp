#pragma once

#include "coilwright/text/rule.hpp"

/// What a command over time, an experiment and a record may say: far beyond any laboratory, and near enough that
/// nothing overflows and a simulation ends.
namespace coilwright::formats {

inline constexpr text::Rule level_rule = text::Rule::between(-1e6, 1e6);  ///< of an input, in the column's unit
inline constexpr text::Rule time_rule = text::Rule::between(0.0, 1e5);    ///< s
inline constexpr text::Rule duration_rule = text::Rule::above(0.0).and_also(text::Rule::at_most(1e5));   ///< s
inline constexpr text::Rule frequency_rule = text::Rule::above(0.0).and_also(text::Rule::at_most(1e6));  ///< Hz
inline constexpr text::Rule measured_rule = text::Rule::between(-1e12, 1e12);  ///< of a record, in SI
/// A standard deviation, in the column's unit. Outside, no instrument: a fit would drown in it, or overflow.
inline constexpr text::Rule sigma_rule = text::Rule::between(1e-12, 1e12);

}  // namespace coilwright::formats
