#include "measurement/compare/settled_model_error.hpp"

#include <tbb/parallel_for.h>

#include <optional>
#include <utility>
#include <vector>

#include "measurement/compare/model_error.hpp"
#include "measurement/compare/other_optima.hpp"
#include "measurement/compare/staged_fit.hpp"
#include "measurement/fit/input_errors.hpp"
#include "measurement/fit/outliers.hpp"

namespace coilwright::measurement::compare {
namespace {

// From where it was, and from the declared numbers: priors that held too little may have led far from these.
fit::Counted<FittedHypothesis> fitted_anew(std::span<const replay::PreparedRun> runs, const FittedHypothesis& known) {
  fit::Counted<FittedHypothesis> out{.value = known};
  bool any = false;
  for (const PlannedFit& plan :
       {PlannedFit{.hypothesis = known.hypothesis, .start = known.fit.values, .local_numbers_from = &known.fit},
        from_declared_numbers(known, known.hypothesis.effects_at(known.fit.values))}) {
    auto there = fit_exactly(runs, plan);
    out.simulated_runs += there.simulated_runs;
    if (!there.value || (any && there.value->fit.objective() >= out.value.fit.objective())) continue;
    out.value = std::move(*there.value);
    any = true;
  }
  return out;
}

}  // namespace

fit::Counted<Attribution> with_settled_model_error(std::span<replay::PreparedRun> runs, Attribution found) {
  // What a model leaves hardly depends on the weight of its priors.
  constexpr int most_rounds = 3;
  fit::Counted<Attribution> out{.value = std::move(found)};
  for (int round = 0; round < most_rounds; ++round) {
    const FittedHypothesis& after = out.value.after();
    const bool taken_back = fit::take_back(runs, after.fit);
    const double model_error = model_error_of(runs, after);
    const bool lets_input_errors_through_otherwise = round == 0 && replay::weighs_input_errors(runs);
    if (!taken_back && !lets_input_errors_through_otherwise &&
        is_same_model_error(model_error, replay::model_error_of(runs)))
      break;
    set_model_error(runs, model_error);
    fit::weigh_input_errors(runs, after.hypothesis, after.fit.values, &after.fit);
    std::vector<FittedHypothesis*> all;
    for (FittedHypothesis& step : out.value.steps) all.push_back(&step);
    for (FittedHypothesis& rival : out.value.rivals) all.push_back(&rival);
    std::vector<long> simulated_runs(all.size());
    tbb::parallel_for(std::size_t{0}, all.size(), [&](std::size_t i) {
      fit::Counted<FittedHypothesis> anew = fitted_anew(runs, *all[i]);
      simulated_runs[i] = anew.simulated_runs;
      *all[i] = std::move(anew.value);
    });
    for (const long each : simulated_runs) out.simulated_runs += each;
  }
  return out;
}

}  // namespace coilwright::measurement::compare
