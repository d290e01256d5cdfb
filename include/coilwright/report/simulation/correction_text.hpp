#pragma once

#include <span>
#include <string>

#include "coilwright/simulation/correction_reach.hpp"

namespace coilwright::report {

/// What a reader must know of a nameless correction: that the model has one, where it was measured, and where it is
/// used beyond. Empty for a model without.
[[nodiscard]] std::string to_text(std::span<const simulation::CorrectionReach> reach);

}  // namespace coilwright::report
