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

PlannedExtension one_more(const FittedHypothesis& base, const EffectKind* kind,
                          std::span<const ScreenedEffect> screened, std::size_t own) {
  PlannedExtension out{.base = &base};
  for (const Effect& start : starts_for_short_fit(kind, screened)) out.starts.push_back({start});
  out.predicted_fall = largest_predicted_fall(kind, screened);
  // An effect of one number has one shape.
  if (kind->parameters().size() < 2) return out;
  for (Effect& start : own_starts(kind, screened, own)) out.further_starts.push_back({std::move(start)});
  return out;
}

}  // namespace coilwright::measurement::identification
