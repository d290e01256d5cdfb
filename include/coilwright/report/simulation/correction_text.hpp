#pragma once

#include <span>
#include <string>

#include "coilwright/report/simulation/document.hpp"
#include "coilwright/simulation/correction_reach.hpp"

namespace coilwright::report {

/// The remarks on a nameless correction: that the model has one, where it was measured, and where it is used beyond.
/// Empty for a model without one.
[[nodiscard]] std::string to_text(std::span<const simulation::CorrectionReach> reach);

/// These remarks as a section; without blocks for a model without a correction.
[[nodiscard]] Section correction_section(std::span<const simulation::CorrectionReach> reach);

}  // namespace coilwright::report
