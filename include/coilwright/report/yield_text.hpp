#pragma once

#include <string>

#include "coilwright/sizing/study/yield.hpp"

namespace coilwright::report {

/// What becomes of a design when it is built, for a person.
[[nodiscard]] std::string to_text(const sizing::Yield& yield);

/// Of that the line on the builds that keep every limit, and one for each limit that fewer builds keep than is asked
/// for, beyond the error of the dice; of these none where there are none.
[[nodiscard]] std::string share_text(const sizing::Yield& yield);
[[nodiscard]] std::string shortfalls_text(const sizing::Yield& yield);

}  // namespace coilwright::report
