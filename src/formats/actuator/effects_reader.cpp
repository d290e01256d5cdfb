#include "formats/actuator/actuator_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "coilwright/text/spelling.hpp"
#include "coilwright/units/unit.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using actuator::Effect;
using actuator::EffectCatalogue;
using actuator::EffectKind;
using actuator::EffectParameter;

// Where the catalogue sets no bound. Far: a rig of 100 kg has drags and stops of 1e9 in the units of a finger.
constexpr double largest_parameter = 1e12;

const EffectKind& read_kind(const Node& node, const EffectCatalogue& known) {
  if (const EffectKind* kind = known.find(node.text())) return *kind;
  std::vector<std::string> ids;
  for (const EffectKind* kind : known.kinds()) ids.emplace_back(kind->id());
  throw node.error("must be the id of an effect" + did_you_mean(node.text(), ids));
}

double read_choice(const Node& node, const EffectParameter& parameter) {
  const double value = node.number();
  std::vector<double> choices(parameter.choices.begin(), parameter.choices.end());
  for (const double choice : choices)
    if (value == units::from_memory(choice, parameter.key)) return choice;
  for (double& choice : choices) choice = units::from_memory(choice, parameter.key);
  throw node.error(fmt::format("must be {}", fmt::join(choices, " or ")));
}

double read_parameter(const Node& node, const EffectParameter& parameter) {
  if (!parameter.choices.empty()) return read_choice(node, parameter);
  const double value =
      units::to_memory(node.number(Rule::between(-largest_parameter, largest_parameter)), parameter.key);
  // In SI: a bound that was written comes back as the very bound, which a rule in the file's unit may miss by a digit.
  if (value < parameter.lower || value > parameter.upper) throw node.error(rule_of(parameter).text());
  return value;
}

std::vector<double> read_values(ObjectReader& in, const EffectKind& kind) {
  std::vector<double> values;
  for (const EffectParameter& parameter : kind.parameters())
    values.push_back(read_parameter(in.at(parameter.key), parameter));
  return values;
}

// The kind with further numbers where one of these is there.
const EffectKind& with_named_numbers(ObjectReader& in, const EffectKind& kind) {
  const EffectKind* further = kind.with_further_numbers();
  if (further == nullptr) return kind;
  for (const EffectParameter& parameter : further->parameters().subspan(kind.parameters().size()))
    if (in.find(parameter.key)) return *further;
  return kind;
}

Effect read_effect(const Node& node, const EffectCatalogue& known, const std::vector<Effect>& before) {
  return read_object(node, [&](ObjectReader& in) {
    const Node id = in.at("id");
    const EffectKind& kind = read_kind(id, known);
    const auto same = [&kind](const Effect& other) { return other.kind->id() == kind.id(); };
    if (std::ranges::any_of(before, same)) throw id.error("must not be there twice");
    Effect effect{.kind = &kind, .values = {}};
    const auto parameters = kind.parameters().empty() ? in.find("parameters") : in.at("parameters");
    if (parameters)
      effect = read_object(*parameters, [&](ObjectReader& numbers) {
        const EffectKind& named = with_named_numbers(numbers, kind);
        return Effect{.kind = &named, .values = read_values(numbers, named)};
      });
    actuator::validate_effect(effect);
    return effect;
  });
}

}  // namespace

Rule rule_of(const EffectParameter& parameter) {
  const double lower = units::from_memory(parameter.lower, parameter.key);
  const double upper = units::from_memory(parameter.upper, parameter.key);
  return Rule::between(std::max(lower, -largest_parameter), std::min(upper, largest_parameter));
}

std::vector<Effect> read_effects(ObjectReader& in, const EffectCatalogue& known) {
  std::vector<Effect> effects;
  if (const auto list = in.find("effects"))
    for (const Node& node : list->elements(Length::from_to(0, known.kinds().size())))
      effects.push_back(read_effect(node, known, effects));
  return effects;
}

}  // namespace coilwright::formats
