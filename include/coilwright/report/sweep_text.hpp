#pragma once

#include <string>

#include "coilwright/formats/study/sweep_json.hpp"

namespace coilwright::report {

/// The leaders as a table: variables, objectives, and what each is best for or, if none is feasible, the limits that it
/// violates; then the counts.
[[nodiscard]] std::string to_text(const formats::SweepReport& report);

}  // namespace coilwright::report
