#include "coilwright/formats/actuator/effect_argument.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "coilwright/text/argument.hpp"
#include "coilwright/text/one_line.hpp"
#include "coilwright/text/spelling.hpp"
#include "coilwright/units/unit.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using actuator::Effect;
using actuator::EffectCatalogue;
using actuator::EffectKind;
using actuator::EffectParameter;

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

// The kind with further numbers where the list names one of these.
const EffectKind& with_named_numbers(const EffectKind& kind, std::string_view list) {
  const EffectKind* further = kind.with_further_numbers();
  if (further == nullptr) return kind;
  const auto names = further->parameters().subspan(kind.parameters().size());
  for (bool more = !list.empty(); more;) {
    const std::size_t comma = list.find(',');
    const std::string_view each = list.substr(0, comma);
    if (std::ranges::find(names, each.substr(0, each.find('=')), &EffectParameter::key) != names.end()) return *further;
    more = comma != std::string_view::npos;
    if (more) list.remove_prefix(comma + 1);
  }
  return kind;
}

// "a=1,b=2" as values in the order of the kind's parameters.
std::vector<double> values_of(std::string_view argument, const EffectKind& kind, std::string_view list) {
  std::vector<std::optional<double>> given(kind.parameters().size());
  for (bool more = !list.empty(); more;) {
    const std::size_t comma = list.find(',');
    const NameAndValue each = split_assignment(argument, list.substr(0, comma), "dry_friction:torque_Nmm=0.6");
    const std::size_t index = index_of(argument, kind, each.name);
    if (given[index]) throw argument_error(argument, in_quotes(each.name) + " must not be there twice");
    given[index] = units::to_memory(number_of(argument, each.value), kind.parameters()[index].key);
    more = comma != std::string_view::npos;
    if (more) list.remove_prefix(comma + 1);
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

}  // namespace coilwright::formats
