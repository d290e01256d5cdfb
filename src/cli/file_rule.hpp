#pragma once

#include <CLI/CLI.hpp>

namespace coilwright::cli {

/// For an input that a command reads more than once, to check it and to copy it or its digest: "-", which is standard
/// input everywhere else, is refused.
[[nodiscard]] CLI::Validator file_rule();

}  // namespace coilwright::cli
