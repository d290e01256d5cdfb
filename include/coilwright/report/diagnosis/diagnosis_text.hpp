#pragma once

#include <string>

#include "coilwright/formats/data/diagnosis_json.hpp"

namespace coilwright::report {

/// The results of `diagnose` for a person: the verdict, the effects and their numbers, the errors before and after, the
/// hypotheses compared, and what to measure next.
[[nodiscard]] std::string to_text(const formats::DiagnosisReport& report);

/// The sentences of that text that a page shows too, as in diagnosis.json. They lack rivals and next steps if the
/// diagnosis was interrupted. `report.summary` is not read.
[[nodiscard]] formats::DiagnosisSummary summary_of(const formats::DiagnosisReport& report);

}  // namespace coilwright::report
