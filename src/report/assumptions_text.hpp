#pragma once

#include <string>

#include "coilwright/formats/study/size_json.hpp"

namespace coilwright::report {

/// What the answer of a study rests on: for each other modelling choice the objective and the worst margin of the same
/// design, whether another design would then be better, and the measurement to make first. Empty where none was
/// looked at.
[[nodiscard]] std::string assumptions_text(const formats::SizeReport& report);

}  // namespace coilwright::report
