#pragma once

#include <string>

#include "coilwright/sizing/study/yield.hpp"

namespace coilwright::report {

/// A share of the uses in words: "in every use", or "in 99 % of uses"; > 0 and <= 1.
[[nodiscard]] std::string uses_text(double share);

/// The statistics of the builds of a design, for a person.
[[nodiscard]] std::string to_text(const sizing::Yield& yield);

/// The share of builds that keep every limit of a search's answer, and its objective in these builds, which the search
/// has not seen.
[[nodiscard]] std::string built_text(const sizing::Yield& yield);

/// A line for each limit that fewer builds of such an answer keep than the study asks for, beyond the error of the
/// dice, and one with the cure; empty if there are none.
[[nodiscard]] std::string shortfalls_of_answer_text(const sizing::Yield& yield);

}  // namespace coilwright::report
