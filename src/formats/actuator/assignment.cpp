#include "coilwright/formats/actuator/assignment.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "coilwright/actuator/design/current_shares.hpp"
#include "coilwright/actuator/design/effect_number.hpp"
#include "coilwright/text/argument.hpp"
#include "coilwright/text/spelling.hpp"
#include "coilwright/units/unit.hpp"
#include "formats/actuator/design_reader.hpp"

namespace coilwright::formats {
namespace {

using namespace text;

actuator::Configuration configuration_of(std::string_view text, std::string_view value) {
  using enum actuator::Configuration;
  for (const actuator::Configuration each : {A, B, C, D})
    if (value == actuator::name_of(each)) return each;
  throw argument_error(text, R"(must be one of "A", "B", "C", "D")");
}

double value_of(std::string_view text, std::string_view value, const actuator::Parameter& parameter) {
  const double number = number_of(text, value);
  if (parameter.whole && number != std::floor(number)) throw argument_error(text, "must be a whole number");
  const Rule rule = rule_of(parameter);
  if (!rule.allows(number)) throw argument_error(text, rule.text());
  return number;
}

// A correction was fitted to the motions of one finger.
void require_corrected_geometry(const actuator::Design& design, std::string_view text) {
  if (design.as_built.torque_correction)
    throw argument_error(text,
                         "must not change: the actuator has a nameless torque correction, which holds for the finger "
                         "that was measured alone");
}

}  // namespace

actuator::Design with_assignment(actuator::Design design, std::string_view text) {
  const NameAndValue assignment = split_assignment(text, text, "gap_mm=1.2");
  if (assignment.name == "configuration") {
    require_corrected_geometry(design, text);
    design.layout = actuator::layout_of(configuration_of(text, assignment.value));
    return design;
  }
  if (const actuator::EffectNumber number = actuator::find_effect_number(design, assignment.name);
      number.value != nullptr) {
    require_corrected_geometry(design, text);
    *number.value = units::to_memory(number_of(text, assignment.value), number.parameter->key);
    try {
      for (const actuator::Effect& effect : design.effects) validate_effect(effect);
    } catch (const std::invalid_argument& rule) {
      throw argument_error(text, rule.what());
    }
    return design;
  }
  const actuator::Parameter* parameter = actuator::find_parameter(assignment.name);
  if (parameter == nullptr) {
    std::vector<std::string> names{"configuration"};
    for (const actuator::Parameter& known : actuator::parameters()) names.emplace_back(known.name);
    for (const actuator::Effect& effect : design.effects)
      for (std::size_t i = 0; i < effect.values.size(); ++i) names.push_back(effect_number_name(effect, i));
    throw argument_error(text, "is not a number of a design" + did_you_mean(assignment.name, names));
  }
  if (parameter->section != "surroundings") require_corrected_geometry(design, text);
  if (!parameter->names().empty()) {
    const std::optional<double> named = actuator::value_named(*parameter, assignment.value);
    if (!named) throw argument_error(text, name_rule(*parameter, assignment.value));
    parameter->set(design, *named);
    return design;
  }
  parameter->set(design, units::to_memory(value_of(text, assignment.value, *parameter), parameter->key));
  if (parameter->rule == actuator::ParameterRule::share && share_without_coil(design) > 0)
    throw argument_error(text,
                         fmt::format("must be of a coil that there is: the layout has {}", coil_count(design.layout)));
  return design;
}

}  // namespace coilwright::formats
