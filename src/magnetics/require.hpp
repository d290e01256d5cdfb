#pragma once

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <string_view>

namespace coilwright::magnetics {

/// Throws std::invalid_argument "`name` must be `rule`; got `value`" unless the rule is met.
inline void require(bool met, std::string_view name, std::string_view rule, double value) {
  if (!met) throw std::invalid_argument(fmt::format("{} must be {}; got {}", name, rule, value));
}

inline void require_finite(std::string_view name, double value) {
  require(std::isfinite(value), name, "finite", value);
}

inline void require_positive(std::string_view name, double value) {
  require(std::isfinite(value) && value > 0.0, name, "finite and > 0", value);
}

}  // namespace coilwright::magnetics
