#include "measurement/identification/settled_model_error.hpp"

#include <optional>
#include <utility>
#include <vector>

#include "measurement/fit/input_errors.hpp"
#include "measurement/fit/outliers.hpp"
#include "measurement/fit/parallel.hpp"
#include "measurement/identification/model_error.hpp"
#include "measurement/identification/other_optima.hpp"
#include "measurement/identification/staged_fit.hpp"

namespace coilwright::measurement::identification {
namespace {

// From where it was, and from the declared numbers: priors that held too little may have led far from these.
FittedHypothesis fitted_anew(std::span<const replay::PreparedRun> runs, const FittedHypothesis& known) {
  FittedHypothesis out = known;
  bool any = false;
  for (const PlannedFit& plan :
       {PlannedFit{.hypothesis = known.hypothesis, .start = known.fit.values, .local_numbers_from = &known.fit},
        from_declared_numbers(known, known.hypothesis.effects_at(known.fit.values))}) {
    auto there = fit_exactly(runs, plan);
    if (!there || (any && there->fit.objective() >= out.fit.objective())) continue;
    out = std::move(*there);
    any = true;
  }
  return out;
}

}  // namespace

Attribution with_settled_model_error(std::span<replay::PreparedRun> runs, Attribution found) {
  // What a model leaves hardly depends on the weight of its priors.
  constexpr int most_rounds = 3;
  for (int round = 0; round < most_rounds; ++round) {
    const FittedHypothesis& after = found.after;
    const bool taken_back = fit::take_back(runs, after.fit);
    const double model_error = model_error_of(runs, after);
    const bool lets_input_errors_through_otherwise = round == 0 && replay::weighs_input_errors(runs);
    if (!taken_back && !lets_input_errors_through_otherwise &&
        is_same_model_error(model_error, replay::model_error_of(runs)))
      break;
    set_model_error(runs, model_error);
    fit::weigh_input_errors(runs, after.hypothesis, after.fit.values, &after.fit);
    const bool has_effects = found.has_effects();
    std::vector<FittedHypothesis*> all{&found.before};
    if (has_effects) all.push_back(&found.after);
    for (FittedHypothesis& rival : found.rivals) all.push_back(&rival);
    fit::in_parallel(all.size(), [&](std::size_t i) { *all[i] = fitted_anew(runs, *all[i]); });
    if (!has_effects) found.after = found.before;
  }
  return found;
}

}  // namespace coilwright::measurement::identification
