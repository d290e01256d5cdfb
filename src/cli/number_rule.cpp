#include "number_rule.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "coilwright/text/one_line.hpp"

namespace coilwright::cli {

namespace {

std::string got(std::string_view argument) {
  return "; got " + text::in_quotes(argument);
}

// The number that all of `argument` spells.
template <class Number>
std::optional<Number> spelt(std::string_view argument) {
  Number value{};
  const char* end = argument.data() + argument.size();
  const auto [stop, status] = std::from_chars(argument.data(), end, value);
  if (status != std::errc() || stop != end) return std::nullopt;
  return value;
}

std::optional<double> finite_number(std::string_view argument) {
  const std::optional<double> value = spelt<double>(argument);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

}  // namespace

CLI::Validator number_rule(const text::Rule& rule) {
  const auto complaint = [rule](std::string& argument) -> std::string {
    const std::optional<double> value = finite_number(argument);
    if (!value) return "must be a finite number" + got(argument);
    return rule.allows(*value) ? std::string() : rule.text() + got(argument);
  };
  return CLI::Validator(complaint, "");
}

CLI::Validator whole_number_rule(const text::Rule& rule) {
  const auto rewrite = [rule](std::string& argument) -> std::string {
    const std::optional<double> value = finite_number(argument);
    if (!value || *value != std::floor(*value)) return "must be a whole number" + got(argument);
    const std::optional<std::int64_t> exact = spelt<std::int64_t>(argument);
    // 9007199254740993 is not a double, and the one next to it may be allowed.
    const bool rounded = exact && static_cast<double>(*exact) == *value && static_cast<std::int64_t>(*value) != *exact;
    if (!rule.allows(*value) || rounded) return rule.text() + got(argument);
    argument = fmt::format("{:.0f}", *value);
    return {};
  };
  return CLI::Validator(rewrite, "");
}

}  // namespace coilwright::cli
