#pragma once

#include <string>

#include "coilwright/measurement/diagnosis.hpp"

namespace coilwright::report {

/// How sure the answer is: what these data cannot tell from it, what they refute by little and how that shows itself
/// at the rig.
[[nodiscard]] std::string rivals_text(const measurement::Diagnosis& diagnosis);
/// The table of what was compared; empty where nothing was.
[[nodiscard]] std::string compared_text(const measurement::Diagnosis& diagnosis);

}  // namespace coilwright::report
