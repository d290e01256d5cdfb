#pragma once

#include <string>

namespace coilwright::report {

/// A share as a person reads it, with so many digits and never as a power of ten: "0.123 %", "12.3 %", "1154 %".
[[nodiscard]] std::string percent(double share, int digits = 3);

/// A change by a share with its sign and one decimal: "+3.9 %", "-12.0 %"; "0.0 %" where that is all that is left of
/// it.
[[nodiscard]] std::string percent_change(double share);

}  // namespace coilwright::report
