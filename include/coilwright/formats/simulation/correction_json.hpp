#pragma once

#include <span>

#include "coilwright/simulation/correction_reach.hpp"
#include "coilwright/text/json/json.hpp"

namespace coilwright::formats {

/// The key "torque_correction" of `evaluate --json`: for each variable of a nameless correction where it was measured,
/// where it is used, and whether that is beyond.
[[nodiscard]] text::Json to_json(std::span<const simulation::CorrectionReach> reach);

}  // namespace coilwright::formats
