#include "coilwright/text/rule.hpp"

#include <fmt/format.h>

#include <cmath>

namespace coilwright::text {

std::string Rule::text() const {
  const bool has_lower = std::isfinite(lower_.value), has_upper = std::isfinite(upper_.value);
  if (!has_lower && !has_upper) return "must be finite";
  if (has_lower && has_upper && lower_.included && upper_.included) {
    return fmt::format("must be from {} to {}", lower_.value, upper_.value);
  }
  const std::string lower = fmt::format("{} {}", lower_.included ? ">=" : ">", lower_.value);
  const std::string upper = fmt::format("{} {}", upper_.included ? "<=" : "<", upper_.value);
  if (!has_upper) return "must be " + lower;
  if (!has_lower) return "must be " + upper;
  return "must be " + lower + " and " + upper;
}

}  // namespace coilwright::text
