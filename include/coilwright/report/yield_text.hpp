#pragma once

#include <string>

#include "coilwright/sizing/study/yield.hpp"

namespace coilwright::report {

/// "in every use", or "in 99 % of uses": of a share of the uses, > 0 and <= 1.
[[nodiscard]] std::string uses_text(double share);

/// What becomes of a design when it is built, for a person.
[[nodiscard]] std::string to_text(const sizing::Yield& yield);

/// What builds make of the answer of a search that has not seen them: how many keep every limit, and its objective.
[[nodiscard]] std::string built_text(const sizing::Yield& yield);

/// A line for each limit that fewer builds of such an answer keep than is asked for, beyond the error of the dice, and
/// one with the cure; empty where there are none.
[[nodiscard]] std::string shortfalls_of_answer_text(const sizing::Yield& yield);

}  // namespace coilwright::report
