#include "measurement/identification/hypothesis_extension.hpp"

#include <algorithm>
#include <utility>

namespace coilwright::measurement::identification {

using actuator::Effect;
using actuator::EffectKind;

std::vector<const EffectKind*> PlannedExtension::kinds() const {
  std::vector<const EffectKind*> out = base->kinds();
  for (const Effect& effect : starts.front()) out.push_back(effect.kind);
  std::ranges::sort(out);
  return out;
}

std::vector<PlannedExtension> without_repetitions(std::vector<PlannedExtension> planned) {
  std::vector<std::vector<const EffectKind*>> seen;
  std::erase_if(planned, [&](const PlannedExtension& each) {
    std::vector<const EffectKind*> kinds = each.kinds();
    if (std::ranges::find(seen, kinds) != seen.end()) return true;
    seen.push_back(std::move(kinds));
    return false;
  });
  return planned;
}

PlannedExtension one_more(const FittedHypothesis& base, const std::vector<Effect>& starts) {
  PlannedExtension out{.base = &base};
  for (const Effect& start : starts) out.starts.push_back({start});
  return out;
}

}  // namespace coilwright::measurement::identification
