#pragma once

#include <string>

#include "coilwright/simulation/quantity.hpp"

namespace coilwright::report {

/// For a design with joints that its current holds shut: each change that opens all of them, where to write it, and the
/// rest angle and stroke that follow. Empty if no joint is shut under current.
[[nodiscard]] std::string opening_text(const simulation::DesignView& design);

}  // namespace coilwright::report
