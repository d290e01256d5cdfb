#include "measurement/identification/effect_strength.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace coilwright::measurement::identification {

using actuator::Effect;
using actuator::EffectParameter;

bool may_be_negative(const actuator::EffectKind& kind) {
  return std::ranges::any_of(kind.parameters(), [](const EffectParameter& number) {
    return number.absent && number.lower < *number.absent && number.upper > *number.absent;
  });
}

Effect scaled_from_absent(Effect effect, double share) {
  const auto numbers = effect.kind->parameters();
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (!numbers[i].choices.empty() || !numbers[i].absent || std::isinf(*numbers[i].absent)) continue;
    const double absent = *numbers[i].absent;
    effect.values[i] = std::clamp(absent + share * (effect.values[i] - absent), numbers[i].lower, numbers[i].upper);
  }
  return effect;
}

Effect at_share_of_strength(Effect effect, double share) {
  const auto numbers = effect.kind->parameters();
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (numbers[i].absent && std::isinf(*numbers[i].absent) && numbers[i].choices.empty())
      effect.values[i] = std::clamp(effect.values[i] / share, numbers[i].lower, numbers[i].upper);
  return scaled_from_absent(std::move(effect), share);
}

bool is_absent(const Effect& effect) {
  const auto numbers = effect.kind->parameters();
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (!numbers[i].absent || std::isinf(*numbers[i].absent)) continue;
    const double away = std::abs(effect.values[i] - *numbers[i].absent);
    if (away <= 1e-9 * std::max(1e-12, std::abs(*numbers[i].absent))) return true;
  }
  return false;
}

std::vector<double> choices_of(const Effect& effect) {
  std::vector<double> out;
  const auto numbers = effect.kind->parameters();
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (!numbers[i].choices.empty()) out.push_back(effect.values[i]);
  return out;
}

}  // namespace coilwright::measurement::identification
