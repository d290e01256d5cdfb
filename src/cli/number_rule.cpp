#include "number_rule.hpp"

#include <charconv>
#include <cmath>
#include <string>

#include "coilwright/text/one_line.hpp"

namespace coilwright::cli {

CLI::Validator number_rule(const text::Rule& rule) {
  const auto complaint = [rule](std::string& argument) -> std::string {
    double value{};
    const char* end = argument.data() + argument.size();
    const auto [stop, status] = std::from_chars(argument.data(), end, value);
    const std::string got = "; got " + text::in_quotes(argument);
    if (status != std::errc() || stop != end || !std::isfinite(value)) return "must be a finite number" + got;
    return rule.allows(value) ? std::string() : rule.text() + got;
  };
  return CLI::Validator(complaint, "");
}

}  // namespace coilwright::cli
