#pragma once

#include <string>

#include "coilwright/control/reach.hpp"

namespace coilwright::report {

/// The answer of `reach`: a table of the profiles, the levels of the one that is best in its worst case, and the faults
/// that no profile removes.
[[nodiscard]] std::string to_text(const control::Reach& reach, const control::ReachTask& task);

}  // namespace coilwright::report
