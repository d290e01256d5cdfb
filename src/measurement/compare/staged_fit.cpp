#include "measurement/compare/staged_fit.hpp"

#include <utility>
#include <vector>

#include "measurement/compare/effect_strength.hpp"

namespace coilwright::measurement::compare {
namespace {

using actuator::Effect;

// What the first look spends on a fit before the best are followed to their end.
constexpr fit::FitEffort few_iterations{.iterations = 4, .tolerance = 1e-2};
// Share of a start's strength at which a fit begins anew that went wrong from the start itself.
constexpr double beside_absent = 0.05;

}  // namespace

fit::FitRequest asking(std::span<const replay::Record> records, const Trial& trial) {
  return {.hypothesis = &trial.hypothesis, .records = records, .start = trial.start, .starts_from = trial.starts_from};
}

std::optional<Scored> fitted_to_end(std::span<const replay::Record> records, const Trial& trial) {
  auto fitted = fit::fit(asking(records, trial));
  if (!fitted) return std::nullopt;
  return scored(records, trial.hypothesis, std::move(*fitted));
}

Trial with(const Scored& base, std::span<const Effect> added) {
  std::vector<Effect> effects = base.hypothesis.effects_at(base.fit.values);
  effects.insert(effects.end(), added.begin(), added.end());
  Trial trial{.hypothesis = fit::Hypothesis(base.hypothesis.declared(), std::move(effects)), .starts_from = &base.fit};
  trial.start = trial.hypothesis.start();
  trial.start.head(base.fit.values.size()) = base.fit.values;
  return trial;
}

std::optional<Glance> glance_at(std::span<const replay::Record> records, const Scored& base,
                                std::span<const Effect> starts) {
  std::optional<Glance> best;
  const auto look = [&](const Effect& start) {
    Trial trial = with(base, std::span(&start, 1));
    fit::FitRequest request = asking(records, trial);
    request.effort = few_iterations;
    auto fitted = fit::fit(request);
    if (!fitted || (best && fitted->chi_square >= best->fitted.chi_square)) return;
    best.emplace(Glance{.trial = std::move(trial), .fitted = std::move(*fitted)});
  };
  for (const Effect& start : starts) look(start);
  // A start so strong that the fit lost its way: again from beside the model without the effect.
  if (!best || best->fitted.chi_square >= base.fit.chi_square) {
    for (Effect start : starts) {
      weaken(start, beside_absent);
      look(start);
    }
  }
  return best;
}

std::optional<Scored> followed_to_end(std::span<const replay::Record> records, const Glance& glance) {
  return fitted_to_end(
      records, {.hypothesis = glance.trial.hypothesis, .start = glance.fitted.values, .starts_from = &glance.fitted});
}

}  // namespace coilwright::measurement::compare
