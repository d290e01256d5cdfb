#include "coilwright/actuator/design/effect_number.hpp"

#include <fmt/format.h>

namespace coilwright::actuator {

std::string effect_number_name(const Effect& effect, std::size_t number) {
  return fmt::format("{}.{}", effect.kind->id(), effect.kind->parameters()[number].key);
}

EffectNumber find_effect_number(Design& design, std::string_view name) {
  for (Effect& effect : design.effects)
    for (std::size_t i = 0; i < effect.values.size(); ++i)
      if (effect_number_name(effect, i) == name)
        return {.value = &effect.values[i], .parameter = &effect.kind->parameters()[i]};
  return {};
}

}  // namespace coilwright::actuator
