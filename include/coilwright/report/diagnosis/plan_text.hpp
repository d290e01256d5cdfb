#pragma once

#include <string>

#include "coilwright/formats/data/plan_json.hpp"

namespace coilwright::report {

/// The answer of `plan` for a person: the smallest strength of each effect, the effects that look alike, and the run
/// that would help most.
[[nodiscard]] std::string to_text(const formats::PlanReport& report);

}  // namespace coilwright::report
