#pragma once

#include "coilwright/formats/study/size_json.hpp"
#include "coilwright/report/simulation/document.hpp"

namespace coilwright::report {

/// What `size` says: the best design, the limits that hold it back, what builds make of it, the effect of a step of
/// each variable, and what it rests on.
[[nodiscard]] Document document_of(const formats::SizeReport& report);

}  // namespace coilwright::report
