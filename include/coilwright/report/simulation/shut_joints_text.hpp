#pragma once

#include <string>

#include "coilwright/simulation/quantity.hpp"

namespace coilwright::report {

/// Where joints of a design are shut under its current, each change that opens all of them: what to write and where,
/// and what becomes of rest angle and stroke. Empty where none is shut under current.
[[nodiscard]] std::string opening_text(const simulation::DesignView& design);

}  // namespace coilwright::report
