#include "measurement/identification/recalibration.hpp"

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "measurement/identification/model_error.hpp"
#include "measurement/identification/other_optima.hpp"
#include "measurement/identification/reached_limits.hpp"
#include "measurement/identification/search_effort.hpp"
#include "measurement/identification/staged_fit.hpp"
#include "measurement/identification/weighed_fit.hpp"

namespace coilwright::measurement::identification {
namespace {

// The inputs of the first run that the model cannot follow by itself.
std::string inputs_that_fail(std::span<const replay::PreparedRun> runs, const PlannedFit& plan) {
  for (std::size_t r = 0; r < runs.size(); ++r)
    if (!fit::evaluate_at(fit_request_of(runs.subspan(r, 1), plan))) return "the inputs of " + runs[r].run->name;
  return "these inputs";
}

// From the declared numbers.
FittedHypothesis first_fit(std::span<const replay::PreparedRun> runs, const replay::DeclaredModel& declared) {
  PlannedFit plan{.hypothesis = fit::Hypothesis(declared, {})};
  plan.start = plan.hypothesis.start();
  auto fitted = fit_exactly(runs, plan);
  if (!fitted) throw std::runtime_error("the declared model cannot be simulated under " + inputs_that_fail(runs, plan));
  return std::move(*fitted);
}

// Of a model without effects.
double log_evidence(std::span<const replay::PreparedRun> runs, const FittedHypothesis& fitted) {
  return weighed(runs, fitted, {}).log_evidence;
}

// `out`, or what is more probable in another local optimum. Not what leaves least: faces that are hardly touched at one
// place leave a little less than none, but none are as good over tens of degrees.
FittedHypothesis best_local_optimum(std::span<const replay::PreparedRun> runs, FittedHypothesis out) {
  std::optional<double> most;
  // True if one of them is better.
  const auto take_best = [&](const std::vector<PlannedFit>& plans) {
    bool any = false;
    for (const PlannedFit& other : plans) {
      auto there = fit_exactly(runs, other);
      if (!there) continue;
      if (!most) most = log_evidence(runs, out);
      const double evidence = log_evidence(runs, *there);
      if (!(evidence > *most)) continue;
      most = evidence;
      out = std::move(*there);
      any = true;
    }
    return any;
  };
  const FittedHypothesis first = out;
  take_best(with_other_starts(first, 0));
  constexpr int most_moves = 3;
  for (int move = 0; move < most_moves; ++move) {
    const FittedHypothesis from = out;
    const std::vector<PlannedFit> plans = from_reached_limits(runs, from);
    if (!take_best(plans)) break;
  }
  return out;
}

// As priors are to be weighed against what `fitted` leaves; 1 where that may still be noise to an effect.
double error_to_weigh(std::span<const replay::PreparedRun> runs, const FittedHypothesis& fitted) {
  return fitted.whiteness.level >= search_effort.weighs_model_error ? model_error_of(runs, fitted) : 1.0;
}

}  // namespace

FittedHypothesis recalibrated(std::span<const replay::PreparedRun> runs, const replay::DeclaredModel& declared) {
  return best_local_optimum(runs, first_fit(runs, declared));
}

FittedHypothesis recalibrated_at_its_error(std::span<replay::PreparedRun> runs, const replay::DeclaredModel& declared) {
  constexpr int most_rounds = 3;
  auto out = first_fit(runs, declared);
  // Against the noise alone a model that is far from it takes up what it can by numbers that no rig has (a link of no
  // mass, which trembles): other local optima are looked for only once priors weigh what they should.
  const double at_first = error_to_weigh(runs, out);
  if (is_same_model_error(at_first, replay::model_error_of(runs))) out = best_local_optimum(runs, std::move(out));
  for (int round = 0; round < most_rounds; ++round) {
    const double model_error = error_to_weigh(runs, out);
    if (is_same_model_error(model_error, replay::model_error_of(runs))) break;
    set_model_error(runs, model_error);
    out = recalibrated(runs, declared);
  }
  return out;
}

}  // namespace coilwright::measurement::identification
