#include "coilwright/measurement/identification/posterior.hpp"

#include <algorithm>
#include <functional>
#include <string_view>

namespace coilwright::measurement::identification {

using actuator::EffectKind;

bool are_among(const std::vector<const EffectKind*>& some, const std::vector<const EffectKind*>& of) {
  return std::ranges::all_of(some, [&](const EffectKind* each) {
    return std::ranges::any_of(of, [&](const EffectKind* one) { return one->id() == each->id(); });
  });
}

std::vector<std::string_view> ids_of(const std::vector<const EffectKind*>& effects) {
  std::vector<std::string_view> out;
  for (const EffectKind* kind : effects) out.push_back(kind->id());
  std::ranges::sort(out);
  return out;
}

std::vector<Posterior::Inclusion> Posterior::effects() const {
  std::vector<Inclusion> out;
  for (const WeighedHypothesis& each : hypotheses)
    for (const std::string_view id : ids_of(each.effects)) {
      auto known = std::ranges::find(out, id, &Inclusion::effect);
      if (known == out.end()) known = out.insert(out.end(), {.effect = id});
      known->probability += each.probability;
    }
  std::ranges::stable_sort(out, std::ranges::greater{}, &Inclusion::probability);
  return out;
}

std::vector<const EffectKind*> Posterior::not_tested() const {
  std::vector<const EffectKind*> out;
  for (const RuledOut& each : ruled_out)
    if (each.remark == not_tested_remark) out.insert(out.end(), each.effects.begin(), each.effects.end());
  return out;
}

double Posterior::probability_of(const std::vector<const EffectKind*>& effects) const {
  double sum = 0.0;
  for (const WeighedHypothesis& each : hypotheses)
    if (ids_of(each.effects) == ids_of(effects)) sum += each.probability;
  return sum;
}

double Posterior::probability_of_any(const std::vector<const EffectKind*>& effects) const {
  double sum = 0.0;
  for (const WeighedHypothesis& each : hypotheses)
    if (std::ranges::any_of(effects, [&](const EffectKind* one) { return are_among({one}, each.effects); }))
      sum += each.probability;
  return sum;
}

double Posterior::probability_among(const std::vector<const EffectKind*>& effects) const {
  double sum = 0.0;
  for (const WeighedHypothesis& each : hypotheses)
    if (are_among(each.effects, effects)) sum += each.probability;
  return sum;
}

}  // namespace coilwright::measurement::identification
