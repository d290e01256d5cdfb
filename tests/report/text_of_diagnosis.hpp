#pragma once

#include <string>

#include "coilwright/report/diagnosis/diagnosis_text.hpp"
#include "formats/data/diagnosis_by_hand.hpp"

namespace coilwright::testing {

/// The summary of a diagnosis made by hand.
inline std::string text_of(const measurement::Diagnosis& diagnosis) {
  return report::to_text(report::document_of(report_of(diagnosis)));
}

}  // namespace coilwright::testing
