#pragma once

#include "coilwright/report/simulation/document.hpp"
#include "coilwright/simulation/quantity.hpp"

namespace coilwright::report {

/// For a design with joints that its current holds shut: each change that opens all of them, where to write it, and the
/// rest angle and stroke that follow. Without blocks if no joint is shut under current.
[[nodiscard]] Section opening_section(const simulation::DesignView& design);

}  // namespace coilwright::report
