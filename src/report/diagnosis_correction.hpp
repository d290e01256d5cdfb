#pragma once

#include <string>

#include "coilwright/formats/data/diagnosis_json.hpp"

namespace coilwright::report {

/// What a nameless correction of the torque is, how far it is to be trusted and what it shows; or why there is none.
/// Empty where nothing was left over.
[[nodiscard]] std::string correction_text(const formats::DiagnosisReport& report);

}  // namespace coilwright::report
