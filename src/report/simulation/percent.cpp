#include "coilwright/report/simulation/percent.hpp"

#include <fmt/format.h>

#include <cmath>

namespace coilwright::report {

std::string percent(double share, int digits) {
  const double value = 100.0 * share;
  const bool has_decimals = std::abs(value) + 0.5 < std::pow(10.0, digits);
  return has_decimals ? fmt::format("{:.{}g} %", value, digits) : fmt::format("{:.0f} %", value);
}

std::string percent_change(double share) {
  const std::string text = fmt::format("{:+.1f} %", 100.0 * share);
  return text == "+0.0 %" || text == "-0.0 %" ? text.substr(1) : text;
}

std::string probability_text(double probability) {
  if (!std::isfinite(probability)) return "unknown";
  if (probability > 0.999) return "more than 0.999";
  if (probability < 0.001) return "less than 0.001";
  return fmt::format("{:.3f}", probability);
}

}  // namespace coilwright::report
