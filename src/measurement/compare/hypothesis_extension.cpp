#include "measurement/compare/hypothesis_extension.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace coilwright::measurement::compare {

using actuator::Effect;
using actuator::EffectKind;

std::vector<const EffectKind*> PlannedExtension::kinds() const {
  std::vector<const EffectKind*> out = base->kinds();
  for (std::size_t i = 0; i < (joint ? effects.size() : 1); ++i) out.push_back(effects[i].kind);
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

CountedFit fit_extension(std::span<const replay::PreparedRun> runs, const PlannedExtension& planned) {
  if (planned.joint) return fit_to_convergence(runs, with_added_effects(*planned.base, planned.effects));
  const auto first = short_fit(runs, *planned.base, planned.effects);
  if (!first.value) return {.value = std::nullopt, .simulated_runs = first.simulated_runs};
  CountedFit refined = refine(runs, *first.value);
  refined.simulated_runs += first.simulated_runs;
  return refined;
}

std::vector<PlannedFit> with_other_choices(const FittedHypothesis& fitted) {
  std::vector<PlannedFit> out;
  const std::vector<Effect> effects = fitted.hypothesis.effects_at(fitted.fit.values);
  for (std::size_t e = 0; e < effects.size(); ++e) {
    const auto numbers = effects[e].kind->parameters();
    for (std::size_t n = 0; n < numbers.size(); ++n) {
      for (const double choice : numbers[n].choices) {
        if (choice == effects[e].values[n]) continue;
        std::vector<Effect> changed = effects;
        changed[e].values[n] = choice;
        out.push_back({.hypothesis = fit::Hypothesis(fitted.hypothesis.declared(), std::move(changed)),
                       .start = fitted.fit.values,
                       .local_numbers_from = &fitted.fit});
      }
    }
  }
  return out;
}

}  // namespace coilwright::measurement::compare
