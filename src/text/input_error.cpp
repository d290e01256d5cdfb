#include "coilwright/text/input_error.hpp"

#include <utility>

#include "coilwright/text/one_line.hpp"

namespace coilwright::text {
namespace {

// Longer than any path or sentence of ours; a key of the input that is longer is cut.
constexpr std::size_t longest_part = 600;
constexpr std::size_t longest_rule = 2000;  // with what is to be pasted
constexpr std::size_t longest_value = 120;

std::string line_of(const Fault& fault) {
  std::string line = one_line(fault.file, longest_part);
  if (!fault.place.empty()) line += ": " + one_line(fault.place, longest_part);
  line += ": " + one_line(fault.rule, longest_rule);
  if (!fault.value.empty()) line += "; got " + one_line(fault.value, longest_value);
  return line;
}

}  // namespace

InputError::InputError(Fault fault) : std::runtime_error(line_of(fault)), fault_(std::move(fault)) {}

}  // namespace coilwright::text
