#pragma once

#include <CLI/CLI.hpp>

#include "coilwright/text/rule.hpp"

namespace coilwright::cli {

/// For `app.add_option(...)->check(number_rule(text::positive))`: the argument must be a number as in our files (a
/// point, no NaN, no Infinity) that the rule allows. CLI11 by itself takes "nan" and "inf".
[[nodiscard]] CLI::Validator number_rule(const text::Rule& rule);

}  // namespace coilwright::cli
