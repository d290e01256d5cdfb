#pragma once

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <string_view>

namespace coilwright::systems {

/// Throws std::invalid_argument unless `value` is finite and `holds`: "current must be finite; got nan A".
inline void require(bool holds, std::string_view name, std::string_view rule, double value,
                    std::string_view unit = "") {
  if (!std::isfinite(value) || !holds)
    throw std::invalid_argument(
        fmt::format("{} must be {}; got {:.6g}{}{}", name, rule, value, unit.empty() ? "" : " ", unit));
}

/// Throws std::invalid_argument where there would be nothing to answer.
inline void require_some(bool any, std::string_view what) {
  if (!any) throw std::invalid_argument(fmt::format("there must be at least one of {}", what));
}

}  // namespace coilwright::systems
