#include "coilwright/formats/assignment.hpp"

#include <charconv>
#include <cmath>
#include <string>
#include <vector>

#include "coilwright/formats/input_error.hpp"
#include "coilwright/formats/spelling.hpp"
#include "design_reader.hpp"

namespace coilwright::formats {
namespace {

struct Assignment {
  std::string_view text;
  std::string_view name;
  std::string_view value;

  [[nodiscard]] InputError error(std::string rule) const {
    return InputError({.file = std::string(text), .rule = std::move(rule)});
  }
};

Assignment split(std::string_view text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string_view::npos)
    throw Assignment{.text = text, .name = {}, .value = {}}.error(R"(must be a name and a value, as in "gap_mm=1.2")");
  return {.text = text, .name = text.substr(0, equals), .value = text.substr(equals + 1)};
}

actuator::Configuration configuration_of(const Assignment& assignment) {
  using enum actuator::Configuration;
  for (const actuator::Configuration each : {A, B, C, D})
    if (assignment.value == actuator::name_of(each)) return each;
  throw assignment.error(R"(must be one of "A", "B", "C", "D")");
}

double number_of(const Assignment& assignment, const actuator::Parameter& parameter) {
  double value{};
  const char* end = assignment.value.data() + assignment.value.size();
  const auto [stop, status] = std::from_chars(assignment.value.data(), end, value);
  if (status != std::errc() || stop != end || !std::isfinite(value)) throw assignment.error("must be a finite number");
  if (parameter.whole && value != std::floor(value)) throw assignment.error("must be a whole number");
  const Rule rule = rule_of(parameter);
  if (!rule.allows(value)) throw assignment.error(rule.text());
  return value;
}

}  // namespace

actuator::Design with_assignment(actuator::Design design, std::string_view text) {
  const Assignment assignment = split(text);
  if (assignment.name == "configuration") {
    design.layout = actuator::layout_of(configuration_of(assignment));
    return design;
  }
  const actuator::Parameter* parameter = actuator::find_parameter(assignment.name);
  if (parameter == nullptr) {
    std::vector<std::string> names{"configuration"};
    for (const actuator::Parameter& known : actuator::parameters()) names.emplace_back(known.name);
    throw assignment.error("is not a number of a design" + did_you_mean(assignment.name, names));
  }
  parameter->set(design, number_of(assignment, *parameter) / parameter->denominator);
  return design;
}

}  // namespace coilwright::formats
