#pragma once

#include <string>

namespace coilwright::report {

/// A share for people, with `digits` digits and never as a power of ten: "0.123 %", "12.3 %", "1154 %".
[[nodiscard]] std::string percent(double share, int digits = 3);

/// A relative change with its sign and one decimal: "+3.9 %", "-12.0 %"; "0.0 %" if it rounds to that.
[[nodiscard]] std::string percent_change(double share);

/// "0.970", "more than 0.999" of what is all but certain, "less than 0.001"; "unknown" of what is not finite.
[[nodiscard]] std::string probability_text(double probability);

}  // namespace coilwright::report
