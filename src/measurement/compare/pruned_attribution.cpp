#include "measurement/compare/pruned_attribution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "coilwright/measurement/compare/decision_thresholds.hpp"
#include "measurement/compare/cross_validation.hpp"
#include "measurement/compare/intervals.hpp"
#include "measurement/compare/model_error.hpp"
#include "measurement/compare/relaxed_tolerances.hpp"
#include "measurement/compare/settled_model_error.hpp"

namespace coilwright::measurement::compare {
namespace {

// What a step of an attribution explains.
Evidence evidence_of_step(std::span<const replay::PreparedRun> runs, const Attribution& attribution, std::size_t step) {
  const FittedHypothesis& without = attribution.steps[step - 1];
  const FittedHypothesis& with = attribution.steps[step];
  Evidence out = evidence_between(runs, without, with, attribution.overdispersion);
  const CrossValidation left_out = cross_validated(runs, without, with, attribution.overdispersion);
  out.cross_validated_gain = left_out.gain;
  for (const std::size_t run : left_out.unpredictable_runs) out.untold_runs.push_back(runs[run].run->name);
  return out;
}

// The fraction of the squared residual above the noise that a step removes.
double explained_fraction(const FittedHypothesis& without, const FittedHypothesis& with) {
  return (without.fit.chi_square - with.fit.chi_square) / without.chi_square_above_noise();
}

// Why the data do not support the last effect of `with`; nothing if they do.
std::optional<std::string> unsupported(const FittedHypothesis& without, const FittedHypothesis& with,
                                       const Evidence& evidence) {
  // Whatever it explains where it was fitted: an effect must not make runs worse that were left out. Where the run that
  // shows it is not counted, what it does to the others is chance.
  const double least_gain = evidence.untold_runs.empty() ? 0.0 : -decision_thresholds.chance_on_runs_left_out;
  if (evidence.cross_validated_gain <= least_gain) return std::string(worse_on_runs_left_out);
  // The search compared it with a fit of the smaller hypothesis that may have ended elsewhere; this is the best of
  // both.
  if (evidence.criterion_gain < decision_thresholds.decisive_gain)
    return "gains too little over the best fit without it";
  if (with.whiteness.is_white()) return std::nullopt;
  const bool is_later = !without.hypothesis.effects().empty();
  const bool is_untested = std::isnan(evidence.cross_validated_gain) || !evidence.untold_runs.empty();
  const double least = !is_later     ? decision_thresholds.least_explained
                       : is_untested ? decision_thresholds.least_explained_of_one_run
                                     : decision_thresholds.least_explained_later;
  // What it takes away where it was fitted is flattered by the fit; runs left out tell what is its own.
  const double on_fit_runs = explained_fraction(without, with);
  const double on_runs_left_out = is_untested ? 1.0 : evidence.cross_validated_gain;
  if (const double explained = std::min(on_fit_runs, on_runs_left_out); explained < least)
    return fmt::format("explains {:.0f} % of what is left over{}, less than {:.0f} %",
                       std::floor(100.0 * std::max(explained, 0.0)),
                       on_runs_left_out < on_fit_runs ? " on runs left out" : "", 100.0 * least);
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

// The work on one attribution: its last step is asked, and taken away, until one stands.
class Pruning {
 public:
  Pruning(std::span<replay::PreparedRun> runs, Attribution attribution,
          const std::function<void(const std::string&)>& progress)
      : runs_(runs), progress_(progress), out_{.attribution = std::move(attribution)}, found_(out_.attribution) {}

  PrunedAttribution run() && {
    // Far from the noise a better hypothesis that is no answer says nothing of how far off this one may be.
    out_.overdispersion =
        is_far_from_noise(found_.after()) ? overdispersion_of(runs_, found_.after()) : found_.overdispersion;
    refit_last_step();
    for (std::size_t i = 1; i < found_.steps.size(); ++i) out_.evidence.push_back(evidence_of(i));
    while (found_.steps.size() > 1) {
      std::optional<std::string> reason = reason_against_last_step();
      if (!reason && without().whiteness.is_white()) reason = reason_why_numbers_suffice();
      if (!reason) return std::move(out_);
      set_remark(found_.compared, found_.after().kinds(), *reason);
      drop_last_step();
    }
    estimate_last_step();
    return std::move(out_);
  }

 private:
  [[nodiscard]] const FittedHypothesis& without() const { return found_.steps[found_.steps.size() - 2]; }

  void refit_last_step() { found_.steps.back() = refitted(runs_, std::move(found_.steps.back())); }

  Evidence evidence_of(std::size_t step) {
    if (progress_) progress_(fmt::format("effect {} of {}: runs left out in turn", step, found_.steps.size() - 1));
    return evidence_of_step(runs_, found_, step);
  }

  // Whether a profile has moved it to a better optimum.
  bool estimate_last_step() {
    const double objective = found_.after().fit.objective();
    EstimatedHypothesis last = estimated(runs_, std::move(found_.steps.back()), out_.overdispersion, progress_);
    found_.steps.back() = std::move(last.fitted);
    out_.estimates = std::move(last.estimates);
    return found_.after().fit.objective() != objective;
  }

  // Intervals cost most: only what passes without them gets them.
  std::optional<std::string> reason_against_last_step() {
    std::optional<std::string> reason = unsupported(without(), found_.after(), out_.evidence.back());
    if (reason) return reason;
    if (estimate_last_step()) {
      out_.evidence.back() = evidence_of(found_.steps.size() - 1);
      reason = unsupported(without(), found_.after(), out_.evidence.back());
    }
    if (!reason && !all_effects_present(found_.after(), out_.estimates))
      reason = "may be absent: a 95 % interval of its numbers reaches that far";
    return reason;
  }

  // What is left without the last effect is noise already: declared numbers may do what this effect does.
  std::optional<std::string> reason_why_numbers_suffice() {
    if (adds_the_name_of_a_number(without(), found_.after())) {
      // It may be the name of the one number that is off; where others are too, a list of numbers says it all.
      if (probability_of_declared_numbers(found_.after()) < decision_thresholds.least_probability)
        return "is not the only declared number that is off";
    } else if (gain_with_wide_tolerances(runs_, without(), found_.after(), out_.overdispersion) <
               decision_thresholds.decisive_gain) {
      return "explains the data no better than declared numbers that are off";
    }
    const GainOverFreeNumber over = gain_over_a_free_number(runs_, without(), found_.after(), out_.overdispersion);
    if (over.gain < decision_thresholds.decisive_gain)
      return fmt::format("explains the data no better than {} does, if that is off", over.number);
    return std::nullopt;
  }

  void drop_last_step() {
    found_.steps.pop_back();
    out_.evidence.pop_back();
    found_.rivals.clear();
    found_.indistinguishable.clear();
    found_ = with_settled_model_error(runs_, std::move(found_));
    out_.overdispersion = overdispersion_of(runs_, found_.after());
    refit_last_step();
    if (!out_.evidence.empty()) out_.evidence.back() = evidence_of(found_.steps.size() - 1);
  }

  std::span<replay::PreparedRun> runs_;
  const std::function<void(const std::string&)>& progress_;
  PrunedAttribution out_;
  Attribution& found_;
};

}  // namespace

PrunedAttribution prune_unsupported_effects(std::span<replay::PreparedRun> runs, Attribution attribution,
                                            const std::function<void(const std::string&)>& progress) {
  return Pruning(runs, std::move(attribution), progress).run();
}

}  // namespace coilwright::measurement::compare
