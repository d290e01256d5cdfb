#pragma once

#include <string>

#include "coilwright/formats/data/diagnosis_json.hpp"

namespace coilwright::report {

/// What a diagnosis took for granted: the runs, the numbers that were free, moved within tolerances or exact, the noise
/// and the samples that were left out.
[[nodiscard]] std::string diagnosis_assumptions(const formats::DiagnosisReport& report);

}  // namespace coilwright::report
