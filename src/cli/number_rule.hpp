#pragma once

#include <CLI/CLI.hpp>

#include "coilwright/text/rule.hpp"

namespace coilwright::cli {

/// For `app.add_option(...)->check(number_rule(text::positive))`: the argument must be a number as in our files (a
/// point, no NaN, no Infinity) that the rule allows. CLI11 by itself takes "nan" and "inf".
[[nodiscard]] CLI::Validator number_rule(const text::Rule& rule);

/// For `app.add_option(...)->transform(whole_number_rule(rule))`, where the number is stored as an integer: the
/// argument must be a whole number, which may be written as 2000 or 2e3, that the rule allows. CLI11 by itself says
/// of 2.5 that it could not be converted, and takes 010 for eight; here it is ten. `rule` has bounds of at most 2^53.
[[nodiscard]] CLI::Validator whole_number_rule(const text::Rule& rule);

}  // namespace coilwright::cli
