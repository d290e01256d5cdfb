#pragma once

#include "coilwright/formats/data/diagnosis_json.hpp"
#include "coilwright/report/simulation/document.hpp"

namespace coilwright::report {

/// What `diagnose` says: the verdict, what was assumed, the effects and their numbers, the errors before and after, the
/// hypotheses compared, and what to measure next. Without the last if the diagnosis was interrupted. `report.summary`
/// is not read.
[[nodiscard]] Document document_of(const formats::DiagnosisReport& report);

}  // namespace coilwright::report
