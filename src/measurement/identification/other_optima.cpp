#include "measurement/identification/other_optima.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <utility>

#include "measurement/identification/effect_strength.hpp"
#include "measurement/identification/model_error.hpp"
#include "measurement/identification/search_effort.hpp"

namespace coilwright::measurement::identification {
namespace {

using actuator::Effect;

// Each number, discrete choices excepted, multiplied by a random factor, inside its bounds. Drawn by mt19937_64, whose
// numbers are the same on every platform.
Effect scattered(Effect effect, std::mt19937_64& random) {
  const double octaves = std::log2(search_effort.scatter);
  const auto numbers = effect.kind->parameters();
  for (std::size_t i = 0; i < effect.values.size(); ++i) {
    if (!numbers[i].choices.empty() || !std::isfinite(effect.values[i])) continue;
    const double share = static_cast<double>(random() >> 11) * 0x1p-53;
    effect.values[i] =
        std::clamp(effect.values[i] * std::exp2(octaves * (2.0 * share - 1.0)), numbers[i].lower, numbers[i].upper);
  }
  return effect;
}

}  // namespace

PlannedFit from_declared_numbers(const FittedHypothesis& fitted, std::vector<Effect> effects) {
  PlannedFit out{.hypothesis = fit::Hypothesis(fitted.hypothesis.declared(), std::move(effects))};
  out.start = out.hypothesis.start();
  return out;
}

std::vector<PlannedFit> with_other_choices(const FittedHypothesis& fitted) {
  std::vector<PlannedFit> out;
  const std::vector<Effect> effects = fitted.hypothesis.effects_at(fitted.fit.values);
  for (std::size_t e = 0; e < effects.size(); ++e) {
    const auto numbers = effects[e].kind->parameters();
    for (std::size_t n = 0; n < numbers.size(); ++n) {
      for (const double choice : numbers[n].choices) {
        if (choice == effects[e].values[n]) continue;
        std::vector<Effect> changed = effects;
        changed[e].values[n] = choice;
        out.push_back({.hypothesis = fit::Hypothesis(fitted.hypothesis.declared(), std::move(changed)),
                       .start = fitted.fit.values,
                       .local_numbers_from = &fitted.fit,
                       .derivatives_from = &fitted.fit});
      }
    }
  }
  return out;
}

std::vector<PlannedFit> with_other_starts(const FittedHypothesis& fitted, std::uint64_t seed) {
  std::vector<PlannedFit> out;
  const std::vector<Effect> effects = fitted.hypothesis.effects_at(fitted.fit.values);
  if (!effects.empty()) {
    out.push_back(from_declared_numbers(fitted, effects));
    std::vector<Effect> weaker = effects;
    for (Effect& effect : weaker) effect = scaled_from_absent(std::move(effect), search_effort.weaker_restart);
    out.push_back(from_declared_numbers(fitted, std::move(weaker)));
  }
  // Cost functions that are not convex occur for effects with several numbers (a shape besides a size).
  if (std::ranges::any_of(effects, [](const Effect& effect) { return effect.values.size() > 1; })) {
    std::mt19937_64 random(seed);
    std::vector<Effect> moved;
    for (const Effect& effect : effects) moved.push_back(scattered(effect, random));
    out.push_back(from_declared_numbers(fitted, std::move(moved)));
  }
  const auto& numbers = fitted.hypothesis.declared().calibration;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (!numbers[i].other_start) continue;
    // From the other side of where its prior ends, or, if it has none, from whichever start the fit did not end near.
    const auto at = static_cast<Eigen::Index>(i);
    const double value = fitted.fit.values[at];
    const bool is_near_other = numbers[i].tolerance
                                   ? !fitted.hypothesis.parameters()[i].is_pulled(value)
                                   : std::abs(value - *numbers[i].other_start) < std::abs(value - numbers[i].declared);
    PlannedFit plan{.hypothesis = fitted.hypothesis, .start = fitted.fit.values, .local_numbers_from = &fitted.fit};
    plan.start[at] = is_near_other ? numbers[i].declared : *numbers[i].other_start;
    out.push_back(std::move(plan));
    // A face that the finger does not have may have bent all other numbers, and the clocks of the runs, and may still
    // be touched where its prior has ended.
    out.push_back(from_declared_numbers(fitted, effects));
    out.back().start[at] = *numbers[i].other_start;
  }
  return out;
}

std::vector<PlannedFit> from_own_starts(const FittedHypothesis& fitted, const actuator::RigScale& scale) {
  std::vector<PlannedFit> out;
  const std::vector<Effect>& effects = fitted.hypothesis.effects();
  if (effects.size() != 1 || effects.front().values.size() < 2) return out;
  for (std::vector<double>& values : effects.front().kind->starts(scale))
    out.push_back(from_declared_numbers(fitted, {{.kind = effects.front().kind, .values = std::move(values)}}));
  return out;
}

std::vector<PlannedFit> with_further_numbers(const FittedHypothesis& fitted, const actuator::RigScale& scale) {
  std::vector<PlannedFit> out;
  const auto declared = static_cast<Eigen::Index>(fitted.hypothesis.declared().calibration.size());
  const std::vector<Effect> effects = fitted.hypothesis.effects_at(fitted.fit.values);
  for (std::size_t e = 0; e < effects.size(); ++e) {
    const actuator::EffectKind* further = effects[e].kind->with_further_numbers();
    if (further == nullptr) continue;
    std::vector<std::vector<double>> taken;
    const auto plan_from = [&](std::vector<double> values) {
      if (std::ranges::find(taken, values) != taken.end()) return;
      taken.push_back(values);
      std::vector<Effect> larger = effects;
      larger[e] = {.kind = further, .values = std::move(values)};
      PlannedFit plan{.hypothesis = fit::Hypothesis(fitted.hypothesis.declared(), std::move(larger)),
                      .local_numbers_from = &fitted.fit,
                      .derivatives_from = &fitted.fit};
      plan.start = plan.hypothesis.start();
      plan.start.head(declared) = fitted.fit.values.head(declared);
      out.push_back(std::move(plan));
    };
    for (const std::vector<double>& start : further->starts(scale)) {
      std::vector<double> values = start;
      std::ranges::copy(effects[e].values, values.begin());
      plan_from(std::move(values));
      // A fall with the speed may need half the friction that a constant one has.
      if (!is_far_from_noise(fitted)) plan_from(start);
    }
  }
  return out;
}

}  // namespace coilwright::measurement::identification
