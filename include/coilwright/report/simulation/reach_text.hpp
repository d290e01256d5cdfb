#pragma once

#include <string>

#include "coilwright/control/reach.hpp"

namespace coilwright::report {

/// How an angle is reached: a table of the profiles, the levels of the one that is best at its worst, and what no
/// profile mends.
[[nodiscard]] std::string to_text(const control::Reach& reach, const control::ReachTask& task);

/// The profile whose worst finger settles first; the earlier one of equals.
[[nodiscard]] const control::ProfileQuality& best_profile(const control::Reach& reach);

}  // namespace coilwright::report
