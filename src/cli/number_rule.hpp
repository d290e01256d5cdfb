#pragma once

#include <CLI/CLI.hpp>

#include "coilwright/formats/rule.hpp"

namespace coilwright::cli {

/// For `app.add_option(...)->check(number_rule(formats::positive))`: the argument must be a number as in our files (a
/// point, no NaN, no Infinity) that the rule allows. CLI11 by itself takes "nan" and "inf".
[[nodiscard]] CLI::Validator number_rule(const formats::Rule& rule);

}  // namespace coilwright::cli
