#pragma once

#include <string>

#include "coilwright/measurement/diagnosis.hpp"

namespace coilwright::report {

/// The section "How sure, and what else it could be": what these data cannot tell from the answer, what they refute by
/// little and how that shows itself at the rig, and the table of what was compared.
[[nodiscard]] std::string rivals_text(const measurement::Diagnosis& diagnosis);
/// That table alone; empty where nothing was compared.
[[nodiscard]] std::string compared_text(const measurement::Diagnosis& diagnosis);

}  // namespace coilwright::report
