#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "coilwright/text/input_error.hpp"
#include "coilwright/text/number.hpp"

namespace coilwright::text {

/// An error in an argument of the command line, which it shows whole: `gap_mm=-1: must be > 0`.
inline InputError argument_error(std::string_view argument, std::string rule) {
  return InputError({.file = std::string(argument), .rule = std::move(rule)});
}

/// The name and the value of `name=value`.
struct NameAndValue {
  std::string_view name;
  std::string_view value;
};

/// Splits `part` of `argument` at its first '='; `example` shows the expected form.
inline NameAndValue split_assignment(std::string_view argument, std::string_view part, std::string_view example) {
  const std::size_t equals = part.find('=');
  if (equals == std::string_view::npos)
    throw argument_error(argument, "must be a name and a value, as in \"" + std::string(example) + '"');
  return {.name = part.substr(0, equals), .value = part.substr(equals + 1)};
}

/// The number in `value`, in the form of our files (a point, no NaN, no Infinity).
inline double number_of(std::string_view argument, std::string_view value) {
  if (const std::optional<double> number = number_in(value)) return *number;
  throw argument_error(argument, "must be a finite number");
}

}  // namespace coilwright::text
