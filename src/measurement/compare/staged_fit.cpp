#include "measurement/compare/staged_fit.hpp"

#include <utility>
#include <vector>

#include "measurement/compare/effect_strength.hpp"
#include "measurement/compare/search_effort.hpp"

namespace coilwright::measurement::compare {

using actuator::Effect;

fit::FitRequest fit_request_of(std::span<const replay::PreparedRun> runs, const PlannedFit& plan) {
  return {
      .hypothesis = &plan.hypothesis, .runs = runs, .start = plan.start, .local_numbers_from = plan.local_numbers_from};
}

fit::Counted<std::optional<FittedHypothesis>> fit_to_convergence(std::span<const replay::PreparedRun> runs,
                                                                 const PlannedFit& plan) {
  auto fitted = fit::fit(fit_request_of(runs, plan));
  if (!fitted.value) return {.value = std::nullopt, .simulated_runs = fitted.simulated_runs};
  return {.value = score(runs, plan.hypothesis, std::move(*fitted.value)), .simulated_runs = fitted.simulated_runs};
}

PlannedFit with_added_effects(const FittedHypothesis& base, std::span<const Effect> added) {
  std::vector<Effect> effects = base.hypothesis.effects_at(base.fit.values);
  effects.insert(effects.end(), added.begin(), added.end());
  PlannedFit plan{.hypothesis = fit::Hypothesis(base.hypothesis.declared(), std::move(effects)),
                  .local_numbers_from = &base.fit};
  plan.start = plan.hypothesis.start();
  plan.start.head(base.fit.values.size()) = base.fit.values;
  return plan;
}

fit::Counted<std::optional<ShortFit>> short_fit(std::span<const replay::PreparedRun> runs, const FittedHypothesis& base,
                                                std::span<const Effect> guesses) {
  std::optional<ShortFit> best;
  long simulated_runs = 0;
  const auto try_from = [&](const Effect& guess) {
    PlannedFit plan = with_added_effects(base, std::span(&guess, 1));
    fit::FitRequest request = fit_request_of(runs, plan);
    request.effort = search_effort.short_fit;
    auto fitted = fit::fit(request);
    simulated_runs += fitted.simulated_runs;
    if (!fitted.value || (best && fitted.value->objective() >= best->fitted.objective())) return;
    best.emplace(ShortFit{.plan = std::move(plan), .fitted = std::move(*fitted.value)});
  };
  for (const Effect& guess : guesses) try_from(guess);
  // A guess may be so strong that its fit diverges: it is repeated near the model without the effect.
  if (!best || best->fitted.objective() >= base.fit.objective())
    for (const Effect& guess : guesses) try_from(scaled_from_absent(guess, search_effort.retry_strength));
  return {.value = std::move(best), .simulated_runs = simulated_runs};
}

fit::Counted<std::optional<FittedHypothesis>> refine(std::span<const replay::PreparedRun> runs, const ShortFit& from) {
  return fit_to_convergence(
      runs, {.hypothesis = from.plan.hypothesis, .start = from.fitted.values, .local_numbers_from = &from.fitted});
}

}  // namespace coilwright::measurement::compare
