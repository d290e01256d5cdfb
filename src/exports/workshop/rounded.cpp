#include "exports/workshop/rounded.hpp"

#include <fmt/format.h>

#include <charconv>
#include <string>

namespace coilwright::exports {

double rounded(double value) {
  const std::string text = fmt::format("{:.6g}", value);
  double out = value;
  std::from_chars(text.data(), text.data() + text.size(), out);
  return out;
}

}  // namespace coilwright::exports
