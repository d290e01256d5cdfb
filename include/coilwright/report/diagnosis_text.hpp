#pragma once

#include <string>

#include "coilwright/formats/data/diagnosis_json.hpp"

namespace coilwright::report {

/// What `diagnose` found, for a person: the verdict, the effects and their numbers, the errors before and after, the
/// hypotheses compared, and what to measure next.
[[nodiscard]] std::string to_text(const formats::DiagnosisReport& report);

}  // namespace coilwright::report
