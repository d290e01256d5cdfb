#pragma once

#include <string>

#include "coilwright/sizing/study/yield.hpp"

namespace coilwright::report {

/// What becomes of a design when it is built, for a person.
[[nodiscard]] std::string to_text(const sizing::Yield& yield);

}  // namespace coilwright::report
