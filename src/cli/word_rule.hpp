#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace coilwright::cli {

/// For `app.add_option(...)->check(word_rule({"series", "parallel"}))`: the argument must be one of `words`. Its
/// refusal names them, the one that was probably meant and the argument.
[[nodiscard]] CLI::Validator word_rule(std::vector<std::string> words);

}  // namespace coilwright::cli
