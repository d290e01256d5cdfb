#include "measurement/compare/pruned_attribution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "measurement/compare/cross_validation.hpp"
#include "measurement/compare/intervals.hpp"
#include "measurement/compare/model_error.hpp"
#include "measurement/compare/relaxed_tolerances.hpp"
#include "measurement/compare/search_effort.hpp"
#include "measurement/compare/settled_model_error.hpp"

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

// Why the data do not support the last effect of `with`; nothing if they do.
std::optional<std::string> unsupported(const FittedHypothesis& without, const FittedHypothesis& with,
                                       const Evidence& evidence) {
  // Whatever it explains where it was fitted: an effect must not make runs worse that were left out.
  if (evidence.cross_validated_gain <= 0.0) return std::string(worse_on_runs_left_out);
  // The search compared it with a fit of the smaller hypothesis that may have ended elsewhere; this is the best of
  // both.
  if (evidence.quasi_bic_gain < decision_thresholds.decisive_gain)
    return "gains too little over the best fit without it";
  if (with.whiteness.is_white()) return std::nullopt;
  const bool is_later = !without.hypothesis.effects().empty();
  const double least = !is_later                                   ? decision_thresholds.least_explained
                       : std::isnan(evidence.cross_validated_gain) ? decision_thresholds.least_explained_of_one_run
                                                                   : decision_thresholds.least_explained_later;
  if (explained_fraction(without, with) < least) return "explains too little of what is left over";
  return std::nullopt;
}

bool all_effects_present(const FittedHypothesis& fitted, const std::vector<Estimate>& estimates) {
  for (std::size_t i = 0; i < fitted.hypothesis.effects().size(); ++i)
    if (!excludes_absent(fitted, estimates_of_effect(fitted, estimates, i), i)) return false;
  return true;
}

// Says of a hypothesis that was compared why it is not the answer.
void set_remark(std::vector<ComparedHypothesis>& compared, const std::vector<const actuator::EffectKind*>& kinds,
                const std::string& remark) {
  for (ComparedHypothesis& each : compared)
    if (std::ranges::is_permutation(each.effects, kinds)) each.remark = remark;
}

}  // namespace

PrunedAttribution prune_unsupported_effects(std::span<replay::PreparedRun> runs, Attribution attribution,
                                            const std::function<void(const std::string&)>& progress) {
  PrunedAttribution out{.attribution = std::move(attribution)};
  Attribution& found = out.attribution;
  // Far from the noise a better hypothesis that is no answer says nothing of how far off this one may be.
  out.overdispersion = is_far_from_noise(found.after()) ? overdispersion_of(runs, found.after()) : found.overdispersion;
  const auto estimate_last_step = [&] {
    EstimatedHypothesis estimated =
        refit_and_estimate(runs, std::move(found.steps.back()), out.overdispersion, progress);
    found.steps.back() = std::move(estimated.fitted);
    out.estimates = std::move(estimated.estimates);
    out.simulated_runs += estimated.simulated_runs;
  };
  const auto evidence_of = [&](std::size_t step) {
    if (progress) progress(fmt::format("effect {} of {}: runs left out in turn", step, found.steps.size() - 1));
    const fit::Counted<Evidence> evidence = evidence_of_step(runs, found, step);
    out.simulated_runs += evidence.simulated_runs;
    return evidence.value;
  };
  estimate_last_step();
  for (std::size_t i = 1; i < found.steps.size(); ++i) out.evidence.push_back(evidence_of(i));
  while (found.steps.size() > 1) {
    const FittedHypothesis& without = found.steps[found.steps.size() - 2];
    std::optional<std::string> reason = unsupported(without, found.after(), out.evidence.back());
    if (!reason && !all_effects_present(found.after(), out.estimates))
      reason = "may be absent: a 95 % interval of its numbers reaches that far";
    // What is left without the last effect is noise already: numbers may do what this effect does.
    const bool numbers_suffice = without.whiteness.is_white();
    const bool names_a_number = adds_the_name_of_a_number(without, found.after());
    // An effect may be the name of the one number that is off; where others are too, a list of numbers says it all.
    if (!reason && numbers_suffice && names_a_number &&
        probability_of_declared_numbers(found.after()) < decision_thresholds.least_probability)
      reason = "is not the only declared number that is off";
    if (!reason && numbers_suffice && !names_a_number) {
      const fit::Counted<double> gain = gain_with_wide_tolerances(runs, without, found.after(), out.overdispersion);
      out.simulated_runs += gain.simulated_runs;
      if (gain.value < decision_thresholds.decisive_gain)
        reason = "explains the data no better than declared numbers that are off";
    }
    if (!reason) break;
    set_remark(found.compared, found.after().kinds(), *reason);
    found.steps.pop_back();
    out.evidence.pop_back();
    found.rivals.clear();
    found.indistinguishable.clear();
    fit::Counted<Attribution> settled = with_settled_model_error(runs, std::move(found));
    found = std::move(settled.value);
    out.simulated_runs += settled.simulated_runs;
    out.overdispersion = overdispersion_of(runs, found.after());
    estimate_last_step();
    if (!out.evidence.empty()) out.evidence.back() = evidence_of(found.steps.size() - 1);
  }
  return out;
}

}  // namespace coilwright::measurement::compare
