#pragma once

#include <span>
#include <string>

namespace coilwright::cli {

/// Throws InputError if two arguments of the form name=value have one name: the second would win, and nobody would
/// know. `gap_mm=1.3: must not be there twice: gap_mm=1.2 sets it too`.
void require_names_once(std::span<const std::string> arguments);

}  // namespace coilwright::cli
