#pragma once

#include <string>

#include "coilwright/control/reach.hpp"

namespace coilwright::report {

/// How an angle is reached: a table of the profiles, the levels of the one that is best at its worst, and what no
/// profile mends.
[[nodiscard]] std::string to_text(const control::Reach& reach, const control::ReachTask& task);

}  // namespace coilwright::report
