#include "coilwright/formats/actuator/actuator_argument.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "coilwright/actuator/design/current_shares.hpp"
#include "coilwright/actuator/design/effect_number.hpp"
#include "coilwright/text/argument.hpp"
#include "coilwright/text/one_line.hpp"
#include "coilwright/text/spelling.hpp"
#include "coilwright/units/unit.hpp"
#include "formats/actuator/actuator_reader.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using actuator::Effect;
using actuator::EffectCatalogue;
using actuator::EffectKind;
using actuator::EffectParameter;

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

const EffectKind& kind_of(std::string_view argument, std::string_view id, const EffectCatalogue& known) {
  if (const EffectKind* kind = known.find(id)) return *kind;
  std::vector<std::string> ids;
  for (const EffectKind* kind : known.kinds()) ids.emplace_back(kind->id());
  throw argument_error(argument, in_quotes(id) + " is not an effect" + did_you_mean(id, ids));
}

std::size_t index_of(std::string_view argument, const EffectKind& kind, std::string_view key) {
  const auto parameters = kind.parameters();
  const auto found = std::ranges::find(parameters, key, &EffectParameter::key);
  if (found != parameters.end()) return static_cast<std::size_t>(found - parameters.begin());
  if (parameters.empty()) throw argument_error(argument, std::string(kind.id()) + " has no parameters");
  std::vector<std::string> keys;
  for (const EffectParameter& known : parameters) keys.emplace_back(known.key);
  throw argument_error(argument,
                       in_quotes(key) + " is not a parameter of " + std::string(kind.id()) + did_you_mean(key, keys));
}

// "a=1" and "b=2" of "a=1,b=2".
std::vector<std::string_view> parts_of(std::string_view list) {
  std::vector<std::string_view> parts;
  for (bool more = !list.empty(); more;) {
    const std::size_t comma = list.find(',');
    parts.push_back(list.substr(0, comma));
    more = comma != std::string_view::npos;
    if (more) list.remove_prefix(comma + 1);
  }
  return parts;
}

// The kind with further numbers where the list names one of these.
const EffectKind& with_named_numbers(const EffectKind& kind, std::string_view list) {
  const EffectKind* further = kind.with_further_numbers();
  if (further == nullptr) return kind;
  const auto names = further->parameters().subspan(kind.parameters().size());
  for (const std::string_view each : parts_of(list))
    if (std::ranges::find(names, each.substr(0, each.find('=')), &EffectParameter::key) != names.end()) return *further;
  return kind;
}

// "a=1,b=2" as values in the order of the kind's parameters.
std::vector<double> values_of(std::string_view argument, const EffectKind& kind, std::string_view list) {
  std::vector<std::optional<double>> given(kind.parameters().size());
  for (const std::string_view part : parts_of(list)) {
    const NameAndValue each = split_assignment(argument, part, "dry_friction:torque_Nmm=0.6");
    const std::size_t index = index_of(argument, kind, each.name);
    if (given[index]) throw argument_error(argument, in_quotes(each.name) + " must not be there twice");
    given[index] = units::to_memory(number_of(argument, each.value), kind.parameters()[index].key);
  }
  std::vector<double> values;
  for (std::size_t i = 0; i < given.size(); ++i) {
    if (!given[i])
      throw argument_error(
          argument, "needs " + std::string(kind.parameters()[i].key) + ": " + std::string(kind.parameters()[i].text));
    values.push_back(*given[i]);
  }
  return values;
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

Effect parse_effect(std::string_view argument, const EffectCatalogue& known) {
  const std::size_t colon = argument.find(':');
  const std::string_view list = colon == std::string_view::npos ? std::string_view() : argument.substr(colon + 1);
  const EffectKind& kind = with_named_numbers(kind_of(argument, argument.substr(0, colon), known), list);
  Effect effect{.kind = &kind, .values = values_of(argument, kind, list)};
  try {
    actuator::validate_effect(effect);
  } catch (const std::invalid_argument& mistake) {
    throw argument_error(argument, mistake.what());
  }
  return effect;
}

std::vector<Effect> parse_hidden_effects(std::span<const std::string> arguments, const actuator::ModelSpec& nominal,
                                         const std::string& who, const EffectCatalogue& known) {
  std::vector<Effect> hidden;
  for (const std::string& argument : arguments) {
    const Effect effect = parse_effect(argument, known);
    if (std::ranges::count(hidden, effect.kind, &Effect::kind) > 0)
      throw argument_error(argument, "must not be there twice");
    if (std::ranges::count(nominal.effects, effect.kind, &Effect::kind) > 0)
      throw argument_error(argument, fmt::format("is declared in {} already", who));
    if (const auto reason = effect.kind->inapplicable(nominal))
      throw argument_error(argument, fmt::format("cannot be in {}: {}", who, *reason));
    hidden.push_back(effect);
  }
  return hidden;
}

}  // namespace coilwright::formats
