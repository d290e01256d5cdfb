#include "measurement/identification/larger_hypotheses.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "measurement/identification/joint_screening.hpp"
#include "measurement/identification/posterior.hpp"
#include "measurement/identification/search_effort.hpp"

namespace coilwright::measurement::identification {
namespace {

using actuator::Effect;
using actuator::EffectKind;

// A larger hypothesis, and the logarithm of the weight that its screening promises.
struct PromisedExtension {
  double log_weight{};
  PlannedExtension extension{};
};

bool is_fitted(const FittedSoFar& so_far, const std::vector<const EffectKind*>& kinds) {
  return std::ranges::any_of(
      so_far.all, [&](const FittedHypothesis& each) { return std::ranges::is_permutation(each.kinds(), kinds); });
}

std::vector<const FittedHypothesis*> heaviest(const FittedSoFar& so_far, std::size_t most) {
  std::vector<const FittedHypothesis*> out{&so_far.before};
  for (const FittedHypothesis& each : so_far.all) out.push_back(&each);
  std::ranges::stable_sort(out, std::ranges::greater{},
                           [&](const FittedHypothesis* each) { return so_far.weight.of(*each); });
  out.resize(std::min(out.size(), most));
  return out;
}

}  // namespace

double RoughWeight::of(const FittedHypothesis& fitted) const {
  return log_prior(fitted.kinds(), kinds, beliefs) - 0.5 * quasi_bic(fitted, overdispersion);
}

double RoughWeight::of(const FittedHypothesis& base, const std::vector<Effect>& effects, double fall) const {
  std::vector<const EffectKind*> all = base.kinds();
  double numbers = 0.0;
  for (const Effect& each : effects) {
    all.push_back(each.kind);
    numbers += static_cast<double>(std::max<std::size_t>(1, each.values.size()));
  }
  return log_prior(all, kinds, beliefs) - 0.5 * (quasi_bic(base, overdispersion) - fall / overdispersion +
                                                 numbers * penalty_per_number(base, overdispersion));
}

std::vector<PlannedExtension> larger_hypotheses_with_weight(const FittedSoFar& so_far) {
  if (so_far.all.empty()) return {};
  const std::vector<const FittedHypothesis*> best = heaviest(so_far, search_effort.extended);
  const double least = so_far.weight.of(*best.front()) + std::log(search_effort.least_weight);
  std::vector<PromisedExtension> promising;
  const auto consider = [&](const FittedHypothesis& base, const std::vector<Effect>& effects, double fall) {
    if (base.hypothesis.effects().size() + effects.size() > search_effort.largest_hypothesis) return;
    if (const double promised = so_far.weight.of(base, effects, fall); promised >= least)
      promising.push_back({.log_weight = promised, .extension = {.base = &base, .starts = {effects}}});
  };
  // What leaves noise cannot be explained better, only with more effects: no extension of what weighs next to nothing
  // beside it will weigh more.
  for (const FittedHypothesis* base : best)
    if (base != &so_far.before && so_far.weight.of(*base) >= least)
      for (const ScreenedEffect& each : so_far.screen(*base))
        consider(*base, {each.effect}, each.predicted_chi_square_fall);
  const std::size_t size = std::max<std::size_t>(2, best.front()->hypothesis.effects().size());
  for (const ScreenedCombination& each :
       combinations_by_predicted_fall(so_far.before, so_far.screened, size, search_effort.combinations))
    consider(so_far.before, each.effects, each.predicted_chi_square_fall);
  std::ranges::stable_sort(promising, std::ranges::greater{}, &PromisedExtension::log_weight);
  std::vector<PlannedExtension> planned;
  for (PromisedExtension& each : promising) planned.push_back(std::move(each.extension));
  planned = without_repetitions(std::move(planned));
  std::erase_if(planned, [&](const PlannedExtension& each) { return is_fitted(so_far, each.kinds()); });
  planned.resize(std::min(planned.size(), search_effort.combinations));
  return planned;
}

}  // namespace coilwright::measurement::identification
