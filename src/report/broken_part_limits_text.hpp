#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "coilwright/sizing/study/broken_part_limits.hpp"

namespace coilwright::report {

/// A warning that so many of `designs` designs break limits of their parts, and then conditional ones, each limit with
/// what happens beyond it, and what to do; `which` names the designs: "designs of this front". Empty where none breaks
/// any.
[[nodiscard]] std::string warning_of_parts(std::span<const sizing::BrokenPartLimit> broken, std::string_view which,
                                           std::size_t designs);

}  // namespace coilwright::report
