#pragma once

#include "coilwright/text/rule.hpp"

/// What an experiment and the entry of a run may say: far beyond any laboratory, and near enough that nothing
/// overflows.
namespace coilwright::formats {

inline constexpr text::Rule level_rule = text::Rule::between(-1e6, 1e6);  ///< in the column's unit
inline constexpr text::Rule time_rule = text::Rule::between(0.0, 1e5);    ///< s
inline constexpr text::Rule duration_rule = text::Rule::above(0.0).and_also(text::Rule::at_most(1e5));   ///< s
inline constexpr text::Rule frequency_rule = text::Rule::above(0.0).and_also(text::Rule::at_most(1e6));  ///< Hz

}  // namespace coilwright::formats
