#pragma once

#include "coilwright/formats/study/sweep_json.hpp"
#include "coilwright/report/simulation/document.hpp"

namespace coilwright::report {

/// What `sweep` says: the leaders as a table (variables, objectives, and what each is best for or, if none is feasible,
/// the limits that it violates), and the counts.
[[nodiscard]] Document document_of(const formats::SweepReport& report);

}  // namespace coilwright::report
