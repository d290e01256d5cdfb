#pragma once

#include <string>

#include "coilwright/formats/study/sweep_table.hpp"

namespace coilwright::report {

/// The leaders as a table to read: variables, objectives, what each is best for, and what is in the way where nothing
/// is feasible; then the counts.
[[nodiscard]] std::string to_text(const formats::SweepReport& report);

}  // namespace coilwright::report
