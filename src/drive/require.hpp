#pragma once

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <string_view>

namespace coilwright::drive {

/// Throws std::invalid_argument unless `value` is finite and `holds`: "duty: must be from 0 to 1; got 1.2".
inline void require(bool holds, std::string_view field, std::string_view rule, double value) {
  if (!std::isfinite(value) || !holds)
    throw std::invalid_argument(fmt::format("{}: must be {}; got {}", field, rule, value));
}

inline void require_positive(std::string_view field, double value) {
  require(value > 0.0, field, "finite and > 0", value);
}

inline void require_not_negative(std::string_view field, double value) {
  require(value >= 0.0, field, "finite and >= 0", value);
}

}  // namespace coilwright::drive
