#include "measurement/compare/staged_fit.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <utility>
#include <vector>

#include "measurement/compare/effect_strength.hpp"
#include "measurement/compare/search_effort.hpp"

namespace coilwright::measurement::compare {

using actuator::Effect;

namespace {

// Whether derivatives that may be kept cost much: of declared numbers, or of local numbers that move the model.
bool has_slow_derivatives(std::span<const replay::PreparedRun> runs, const fit::Hypothesis& hypothesis) {
  const auto& numbers = hypothesis.declared().calibration;
  if (!std::ranges::all_of(numbers, &replay::CalibrationParameter::calibrated)) return true;
  return std::ranges::any_of(runs, [](const replay::PreparedRun& run) {
    return run.fits_initial_states() || std::ranges::any_of(run.windows, [](const replay::Window& window) {
             return !window.edges.empty() || !window.bend.times.empty() || !window.errors.empty();
           });
  });
}

// By how much one more step would lower the objective, where it is as the derivatives say.
double predicted_fall(const fit::Fit& fitted) {
  Eigen::MatrixXd jacobian = fitted.jacobian;
  for (std::size_t i = 0; i < fitted.at_bound.size(); ++i)
    if (fitted.at_bound[i]) jacobian.col(static_cast<Eigen::Index>(i)).setZero();
  const Eigen::VectorXd slope = jacobian.transpose() * fitted.stacked_residuals;
  const Eigen::MatrixXd curvature = jacobian.transpose() * jacobian;
  return slope.dot(curvature.completeOrthogonalDecomposition().solve(slope));
}

// Where derivatives cost much, they are taken where a turn begins and follow it to its end. With derivatives of another
// place a fit ends where these see no way down, which is near its optimum only if they have hardly changed: they are
// taken anew there, and another turn begins as long as they promise more.
fit::Counted<std::optional<FittedHypothesis>> fitted_in_turns(std::span<const replay::PreparedRun> runs,
                                                              const PlannedFit& plan, const fit::FitEffort& effort) {
  fit::FitRequest request = fit_request_of(runs, plan);
  request.effort = effort;
  std::optional<fit::Fit> reached;
  long simulated_runs = 0;
  if (!has_slow_derivatives(runs, plan.hypothesis)) {
    auto fitted = fit::fit(request);
    simulated_runs += fitted.simulated_runs;
    reached = std::move(fitted.value);
  } else {
    request.updates_derivatives = true;
    for (int turn = 0; turn < search_effort.most_turns; ++turn) {
      const auto fitted = fit::fit(request);
      simulated_runs += fitted.simulated_runs;
      if (!fitted.value) break;
      auto anew = fit::evaluate_with_jacobian({.hypothesis = &plan.hypothesis,
                                               .runs = runs,
                                               .start = fitted.value->values,
                                               .local_numbers_from = &*fitted.value,
                                               .effort = {.iterations = 0}});
      simulated_runs += anew.simulated_runs;
      if (!anew.value) break;
      const double notable = effort.tolerance * anew.value->objective();
      const bool has_stalled = reached && reached->objective() - anew.value->objective() <= notable;
      reached = std::move(anew.value);
      if (has_stalled || predicted_fall(*reached) <= notable) break;
      request.start = reached->values;
      request.local_numbers_from = request.derivatives_from = &*reached;
    }
  }
  if (!reached) return {.value = std::nullopt, .simulated_runs = simulated_runs};
  return {.value = score(runs, plan.hypothesis, std::move(*reached)), .simulated_runs = simulated_runs};
}

}  // namespace

fit::FitRequest fit_request_of(std::span<const replay::PreparedRun> runs, const PlannedFit& plan) {
  return {.hypothesis = &plan.hypothesis,
          .runs = runs,
          .start = plan.start,
          .local_numbers_from = plan.local_numbers_from,
          .derivatives_from = plan.derivatives_from};
}

fit::Counted<std::optional<FittedHypothesis>> fit_exactly(std::span<const replay::PreparedRun> runs,
                                                          const PlannedFit& plan) {
  return fitted_in_turns(runs, plan, search_effort.exact);
}

fit::Counted<std::optional<FittedHypothesis>> fit_to_convergence(std::span<const replay::PreparedRun> runs,
                                                                 const PlannedFit& plan) {
  return fitted_in_turns(runs, plan, search_effort.converged);
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

fit::Counted<std::optional<ShortFit>> short_fit(std::span<const replay::PreparedRun> runs, const FittedHypothesis& base,
                                                std::span<const std::vector<Effect>> guesses) {
  std::optional<ShortFit> best;
  long simulated_runs = 0;
  const auto try_from = [&](const std::vector<Effect>& guess, bool declared = false) {
    PlannedFit plan = with_added_effects(base, guess);
    if (declared) {
      plan.start = plan.hypothesis.start();
      plan.start.head(base.fit.values.size()) = base.hypothesis.start();
      plan.local_numbers_from = nullptr;
    }
    fit::FitRequest request = fit_request_of(runs, plan);
    request.effort = search_effort.short_fit;
    auto fitted = fit::fit(request);
    simulated_runs += fitted.simulated_runs;
    if (!fitted.value || (best && fitted.value->objective() >= best->fitted.objective())) return;
    best.emplace(ShortFit{.plan = std::move(plan), .fitted = std::move(*fitted.value)});
  };
  for (const std::vector<Effect>& guess : guesses) try_from(guess);
  // Where a missing effect has pulled declared numbers far away, the way back leads through worse models.
  if (base.hypothesis.effects().empty() && probability_of_declared_numbers(base) < search_effort.numbers_pulled_away)
    for (const std::vector<Effect>& guess : guesses) try_from(guess, true);
  // A guess may be so strong that its fit diverges: it is repeated near the model without the effect.
  if (!best || best->fitted.objective() >= base.fit.objective())
    for (std::vector<Effect> guess : guesses) {
      for (Effect& effect : guess) effect = scaled_from_absent(std::move(effect), search_effort.retry_strength);
      try_from(guess);
    }
  return {.value = std::move(best), .simulated_runs = simulated_runs};
}

fit::Counted<std::optional<FittedHypothesis>> refine(std::span<const replay::PreparedRun> runs, const ShortFit& from) {
  return fit_to_convergence(runs, {.hypothesis = from.plan.hypothesis,
                                   .start = from.fitted.values,
                                   .local_numbers_from = &from.fitted,
                                   .derivatives_from = &from.fitted});
}

}  // namespace coilwright::measurement::compare
