#include "measurement/compare/recalibration.hpp"

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "measurement/compare/model_error.hpp"
#include "measurement/compare/other_optima.hpp"
#include "measurement/compare/reached_limits.hpp"
#include "measurement/compare/search_effort.hpp"
#include "measurement/compare/staged_fit.hpp"

namespace coilwright::measurement::compare {
namespace {

// The inputs of the first run that the model cannot follow by itself.
std::string inputs_that_fail(std::span<const replay::PreparedRun> runs, const PlannedFit& plan) {
  for (std::size_t r = 0; r < runs.size(); ++r)
    if (!fit::evaluate_at(fit_request_of(runs.subspan(r, 1), plan)).value) return "the inputs of " + runs[r].run->name;
  return "these inputs";
}

// From the declared numbers.
fit::Counted<FittedHypothesis> first_fit(std::span<const replay::PreparedRun> runs,
                                         const replay::DeclaredModel& declared) {
  PlannedFit plan{.hypothesis = fit::Hypothesis(declared, {})};
  plan.start = plan.hypothesis.start();
  auto fitted = fit_exactly(runs, plan);
  if (!fitted.value)
    throw std::runtime_error("the declared model cannot be simulated under " + inputs_that_fail(runs, plan));
  return {.value = std::move(*fitted.value), .simulated_runs = fitted.simulated_runs};
}

// `out`, or what is better in another valley.
fit::Counted<FittedHypothesis> best_valley(std::span<const replay::PreparedRun> runs,
                                           fit::Counted<FittedHypothesis> out) {
  // True if one of them is better.
  const auto take_best = [&](const std::vector<PlannedFit>& plans) {
    bool any = false;
    for (const PlannedFit& other : plans) {
      auto there = fit_exactly(runs, other);
      out.simulated_runs += there.simulated_runs;
      if (!there.value || !(there.value->fit.objective() < out.value.fit.objective())) continue;
      out.value = std::move(*there.value);
      any = true;
    }
    return any;
  };
  const FittedHypothesis first = out.value;
  take_best(with_other_starts(first, 0));
  constexpr int most_moves = 3;
  for (int move = 0; move < most_moves; ++move) {
    const FittedHypothesis from = out.value;
    const fit::Counted<std::vector<PlannedFit>> plans = from_reached_limits(runs, from);
    out.simulated_runs += plans.simulated_runs;
    if (!take_best(plans.value)) break;
  }
  return out;
}

// As priors are to be weighed against what `fitted` leaves; 1 where that may still be noise to an effect.
double error_to_weigh(std::span<const replay::PreparedRun> runs, const FittedHypothesis& fitted) {
  return fitted.whiteness.level >= search_effort.weighs_model_error ? model_error_of(runs, fitted) : 1.0;
}

}  // namespace

fit::Counted<FittedHypothesis> recalibrated(std::span<const replay::PreparedRun> runs,
                                            const replay::DeclaredModel& declared) {
  return best_valley(runs, first_fit(runs, declared));
}

fit::Counted<FittedHypothesis> recalibrated_at_its_error(std::span<replay::PreparedRun> runs,
                                                         const replay::DeclaredModel& declared) {
  constexpr int most_rounds = 3;
  auto out = first_fit(runs, declared);
  // Against the noise alone a model that is far from it takes up what it can by numbers that no rig has (a link of no
  // mass, which trembles): other valleys are looked for only once priors weigh what they should.
  const double at_first = error_to_weigh(runs, out.value);
  if (is_same_model_error(at_first, replay::model_error_of(runs))) out = best_valley(runs, std::move(out));
  for (int round = 0; round < most_rounds; ++round) {
    const double model_error = error_to_weigh(runs, out.value);
    if (is_same_model_error(model_error, replay::model_error_of(runs))) break;
    set_model_error(runs, model_error);
    auto anew = recalibrated(runs, declared);
    anew.simulated_runs += out.simulated_runs;
    out = std::move(anew);
  }
  return out;
}

}  // namespace coilwright::measurement::compare
