#pragma once

#include <string>

#include "coilwright/formats/data/diagnosis_json.hpp"

namespace coilwright::report {

/// What `diagnose` found, for a person: the verdict, the effects and their numbers, the errors before and after, the
/// hypotheses compared, and what to measure next.
[[nodiscard]] std::string to_text(const formats::DiagnosisReport& report);

/// The sentences of that text which a page shows too, as diagnosis.json has them. Without rivals and next steps where
/// the diagnosis was interrupted. Does not look at `report.summary`.
[[nodiscard]] formats::DiagnosisSummary summary_of(const formats::DiagnosisReport& report);

}  // namespace coilwright::report
