#include "measurement/identification/staged_fit.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "coilwright/measurement/identification/decision_thresholds.hpp"
#include "measurement/identification/effect_strength.hpp"
#include "measurement/identification/model_error.hpp"
#include "measurement/identification/search_effort.hpp"

namespace coilwright::measurement::identification {

using actuator::Effect;

namespace {

// Whether what is missing may have pulled declared numbers far away: those with tolerances are, all together, hardly
// likely where they are now, or one that is fitted freely is far from what it was declared to be.
bool are_numbers_pulled_away(const FittedHypothesis& base) {
  if (probability_of_declared_numbers(base) < search_effort.numbers_pulled_away) return true;
  if (base.whiteness.is_white()) return false;
  const auto& numbers = base.hypothesis.declared().calibration;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (numbers[i].tolerance) continue;
    const double moved = std::abs(base.fit.values[static_cast<Eigen::Index>(i)] - numbers[i].declared);
    if (moved > search_effort.free_number_pulled_away * std::abs(numbers[i].declared)) return true;
  }
  return false;
}

// Whether a number of an effect that is fitted, not chosen, ended at one of its bounds.
bool ends_at_a_bound(const ShortFit& found) {
  const auto declared = static_cast<std::ptrdiff_t>(found.plan.hypothesis.declared().calibration.size());
  return std::any_of(found.fitted.at_bound.begin() + declared, found.fitted.at_bound.end(),
                     [](char at_bound) { return at_bound != 0; });
}

}  // namespace

std::optional<FittedHypothesis> fit_to_its_end(std::span<const replay::PreparedRun> runs, const PlannedFit& plan,
                                               const fit::FitEffort& effort) {
  FitInTurns fit(runs, plan, effort);
  fit.finish();
  return std::move(fit).result();
}

std::optional<FittedHypothesis> fit_exactly(std::span<const replay::PreparedRun> runs, const PlannedFit& plan) {
  return fit_to_its_end(runs, plan, search_effort.exact);
}

PlannedFit with_added_effects(const FittedHypothesis& base, std::span<const Effect> added) {
  std::vector<Effect> effects = base.hypothesis.effects_at(base.fit.values);
  effects.insert(effects.end(), added.begin(), added.end());
  PlannedFit plan{.hypothesis = fit::Hypothesis(base.hypothesis.declared(), std::move(effects)),
                  .local_numbers_from = &base.fit,
                  .derivatives_from = &base.fit};
  plan.start = plan.hypothesis.start();
  plan.start.head(base.fit.values.size()) = base.fit.values;
  return plan;
}

std::optional<fit::Fit> at_declared_numbers(std::span<const replay::PreparedRun> runs,
                                            const replay::DeclaredModel& declared) {
  if (!has_slow_derivatives(runs, declared)) return {};
  const fit::Hypothesis hypothesis(declared, {});
  return fit::evaluate_with_jacobian(
      {.hypothesis = &hypothesis, .runs = runs, .start = hypothesis.start(), .effort = {.iterations = 0}});
}

fit::FitEffort ends_by_what_is_left(fit::FitEffort effort, const FittedHypothesis& known) {
  const double least_gain =
      std::max(decision_thresholds.decisive_gain, effort.tolerance * known.chi_square_above_noise());
  effort.tolerance = std::min(effort.tolerance, least_gain / known.fit.objective());
  return effort;
}

namespace {

// Short fits of a base with effects added; the best of them.
class ShortFits {
 public:
  ShortFits(std::span<const replay::PreparedRun> runs, const FittedHypothesis& base, std::optional<ShortFit> best)
      : runs_(runs), base_(base), best_(std::move(best)) {}

  void try_from(const std::vector<Effect>& guess) {
    take(with_added_effects(base_, guess), nullptr, search_effort.short_fit);
  }
  // `at_declared`: derivatives there; null: their own.
  void try_from_declared(const std::vector<Effect>& guess, const fit::Fit* at_declared, const fit::FitEffort& effort) {
    PlannedFit plan = with_added_effects(base_, guess);
    plan.start = plan.hypothesis.start();
    plan.start.head(base_.fit.values.size()) = base_.hypothesis.start();
    plan.local_numbers_from = nullptr;
    plan.derivatives_from = nullptr;
    take(std::move(plan), at_declared, effort);
  }

  [[nodiscard]] const std::optional<ShortFit>& best() const { return best_; }
  [[nodiscard]] std::optional<ShortFit> result() && { return std::move(best_); }

 private:
  void take(PlannedFit plan, const fit::Fit* derivatives, const fit::FitEffort& effort) {
    fit::FitRequest request = fit_request_of(runs_, plan);
    if (derivatives != nullptr) request.derivatives_from = derivatives;
    request.effort = ends_by_what_is_left(effort, base_);
    auto fitted = fit::fit(request);
    if (!fitted || (best_ && fitted->objective() >= best_->fitted.objective())) return;
    best_.emplace(ShortFit{.plan = std::move(plan), .fitted = std::move(*fitted)});
  }

  std::span<const replay::PreparedRun> runs_;
  const FittedHypothesis& base_;
  std::optional<ShortFit> best_;
};

}  // namespace

std::optional<ShortFit> short_fit(std::span<const replay::PreparedRun> runs, const FittedHypothesis& base,
                                  std::span<const std::vector<Effect>> guesses) {
  ShortFits fits(runs, base, std::nullopt);
  for (const std::vector<Effect>& guess : guesses) fits.try_from(guess);
  return std::move(fits).result();
}

bool is_worse_than(const FittedHypothesis& base, const std::optional<ShortFit>& larger) {
  if (is_far_from_noise(base)) return false;
  return !larger || larger->fitted.objective() > base.fit.objective() + decision_thresholds.decisive_gain;
}

std::optional<ShortFit> from_other_starts(std::span<const replay::PreparedRun> runs, const FittedHypothesis& base,
                                          std::span<const std::vector<Effect>> guesses,
                                          std::span<const std::vector<Effect>> further, const fit::Fit* at_declared,
                                          std::optional<ShortFit> so_far) {
  ShortFits fits(runs, base, std::move(so_far));
  const std::optional<ShortFit>& best = fits.best();
  // Where a missing effect has pulled declared numbers far away, the way back leads through worse models.
  if (base.hypothesis.effects().empty() && are_numbers_pulled_away(base))
    for (const std::vector<Effect>& guess : guesses)
      fits.try_from_declared(guess, at_declared, search_effort.short_fit);
  // The linearisation that scaled the guesses may have led where the effect has lost its shape, or to next to nothing.
  // Where a model leaves very much, most effects do next to nothing, and long records take their time; where it leaves
  // noise, most effects end absent, which is a bound.
  const bool is_worth_more = base.whiteness.level < search_effort.weighs_model_error && !base.whiteness.is_white();
  const double worth_a_start = search_effort.next_to_nothing * base.chi_square_above_noise();
  if (!best ||
      (is_worth_more && (ends_at_a_bound(*best) || base.fit.objective() - best->fitted.objective() < worth_a_start)))
    for (const std::vector<Effect>& guess : further)
      fits.try_from_declared(guess, at_declared, search_effort.own_start_fit);
  // A guess may be so strong that its fit diverges, or that nothing moves any more: it is repeated nearer to the model
  // without the effect.
  double strength = 1.0;
  for (int i = 0; i < search_effort.most_retries; ++i) {
    if (i == 0 ? best && best->fitted.objective() < base.fit.objective() : !is_worse_than(base, best)) break;
    strength *= search_effort.retry_strength;
    for (std::vector<Effect> guess : guesses) {
      for (Effect& effect : guess) effect = scaled_from_absent(std::move(effect), strength);
      fits.try_from(guess);
    }
  }
  return std::move(fits).result();
}

}  // namespace coilwright::measurement::identification
