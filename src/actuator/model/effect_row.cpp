#include "actuator/model/effect_row.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "coilwright/actuator/model/effect_catalogue.hpp"

namespace coilwright::actuator {
namespace {

// Past the end for a kind that is not among the standard effects, with or without further numbers.
std::ptrdiff_t place_among_standard_effects(const EffectKind* kind) {
  const std::span<const EffectKind* const> all = standard_effects().kinds();
  const auto same = [kind](const EffectKind* each) { return each == kind || each->with_further_numbers() == kind; };
  return std::ranges::find_if(all, same) - all.begin();
}

}  // namespace

std::vector<Effect> effect_row(const ModelSpec& spec) {
  for (std::size_t i = 0; i < spec.effects.size(); ++i) {
    const Effect& effect = spec.effects[i];
    validate_effect(effect);
    const EffectKind& kind = *effect.kind;
    for (std::size_t k = 0; k < i; ++k)
      if (spec.effects[k].kind->id() == kind.id())
        throw std::invalid_argument(fmt::format("effect {}: may be in a model once; given twice", kind.id()));
    if (const std::optional<std::string> reason = kind.inapplicable(spec))
      throw std::invalid_argument(fmt::format("effect {}: {}", kind.id(), *reason));
  }
  std::vector<Effect> row = spec.effects;
  std::ranges::stable_sort(row, {}, [](const Effect& effect) {
    return std::pair(effect.kind->stage(), place_among_standard_effects(effect.kind));
  });
  return row;
}

}  // namespace coilwright::actuator
