#include "measurement/compare/pruned_attribution.hpp"

#include <cstddef>
#include <utility>

#include "measurement/compare/cross_validation.hpp"
#include "measurement/compare/intervals.hpp"
#include "measurement/compare/search_effort.hpp"

namespace coilwright::measurement::compare {
namespace {

// What a step of an attribution explains.
fit::Counted<Evidence> evidence_of_step(std::span<const replay::PreparedRun> runs, const Attribution& attribution,
                                        std::size_t step) {
  const FittedHypothesis& without = attribution.steps[step - 1];
  const FittedHypothesis& with = attribution.steps[step];
  Evidence out = evidence_between(runs, without, with, attribution.overdispersion);
  const fit::Counted<double> gain = cross_validated_gain(runs, without, with);
  out.cross_validated_gain = gain.value;
  return {.value = out, .simulated_runs = gain.simulated_runs};
}

// The fraction of the squared residual above the noise that a step removes.
double explained_fraction(const FittedHypothesis& without, const FittedHypothesis& with) {
  return (without.fit.chi_square - with.fit.chi_square) / without.chi_square_above_noise();
}

bool is_supported(const FittedHypothesis& without, const FittedHypothesis& with, const Evidence& evidence) {
  // Whatever it explains where it was fitted: an effect must not make runs worse that were left out.
  if (evidence.cross_validated_gain <= 0.0) return false;
  // The search compared it with a fit of the smaller hypothesis that may have ended elsewhere; this is the best of
  // both.
  if (evidence.quasi_bic_gain < decision_thresholds.decisive_gain) return false;
  if (with.whiteness.is_white()) return true;
  const double least = without.hypothesis.effects().empty() ? decision_thresholds.least_explained
                                                            : decision_thresholds.least_explained_later;
  return explained_fraction(without, with) >= least;
}

bool all_effects_present(const FittedHypothesis& fitted, const std::vector<Estimate>& estimates) {
  for (std::size_t i = 0; i < fitted.hypothesis.effects().size(); ++i)
    if (!excludes_absent(fitted, estimates_of_effect(fitted, estimates, i), i)) return false;
  return true;
}

}  // namespace

PrunedAttribution prune_unsupported_effects(std::span<const replay::PreparedRun> runs, Attribution attribution) {
  PrunedAttribution out{.attribution = std::move(attribution)};
  Attribution& found = out.attribution;
  out.overdispersion = found.overdispersion;
  const auto estimate_last_step = [&] {
    EstimatedHypothesis estimated = refit_and_estimate(runs, std::move(found.steps.back()), out.overdispersion);
    found.steps.back() = std::move(estimated.fitted);
    out.estimates = std::move(estimated.estimates);
    out.simulated_runs += estimated.simulated_runs;
  };
  const auto evidence_of = [&](std::size_t step) {
    const fit::Counted<Evidence> evidence = evidence_of_step(runs, found, step);
    out.simulated_runs += evidence.simulated_runs;
    return evidence.value;
  };
  estimate_last_step();
  for (std::size_t i = 1; i < found.steps.size(); ++i) out.evidence.push_back(evidence_of(i));
  while (found.steps.size() > 1 &&
         (!is_supported(found.steps[found.steps.size() - 2], found.after(), out.evidence.back()) ||
          !all_effects_present(found.after(), out.estimates))) {
    found.steps.pop_back();
    out.evidence.pop_back();
    found.rivals.clear();
    found.indistinguishable.clear();
    out.overdispersion = overdispersion_of(runs, found.after());
    estimate_last_step();
    if (!out.evidence.empty()) out.evidence.back() = evidence_of(found.steps.size() - 1);
  }
  return out;
}

}  // namespace coilwright::measurement::compare
