#include "coilwright/measurement/identification/verdict.hpp"

#include <algorithm>

namespace coilwright::measurement::identification {
namespace {

using actuator::EffectKind;
using Kinds = std::vector<const EffectKind*>;

// The least probability with which a statement is made that costs so much where it is wrong.
double least_probability(double cost) {
  return cost / (1.0 + cost);
}

bool has(const Kinds& effects, const EffectKind* one) {
  return are_among({one}, effects);
}

Kinds without(Kinds effects, std::size_t place) {
  effects.erase(effects.begin() + static_cast<std::ptrdiff_t>(place));
  return effects;
}

// The probability of all hypotheses that have none but these effects.
double probability_among(const Posterior& posterior, const Kinds& effects) {
  double sum = 0.0;
  for (const WeighedHypothesis& each : posterior.hypotheses)
    if (are_among(each.effects, effects)) sum += each.probability;
  return sum;
}

std::size_t most_probable_among(const Posterior& posterior, const Kinds& effects) {
  const auto found = std::ranges::find_if(
      posterior.hypotheses, [&](const WeighedHypothesis& each) { return are_among(each.effects, effects); });
  return static_cast<std::size_t>(found - posterior.hypotheses.begin());
}

std::size_t reported_of(const Posterior& posterior, double most_doubt) {
  std::size_t out = 0;
  while (true) {
    const Kinds& effects = posterior.hypotheses[out].effects;
    double doubt = most_doubt;
    Kinds fewer = effects;
    for (std::size_t i = 0; i < effects.size(); ++i) {
      const double there = probability_among(posterior, without(effects, i));
      if (there <= doubt) continue;
      doubt = there;
      fewer = without(effects, i);
    }
    if (fewer.size() == effects.size()) return out;
    out = most_probable_among(posterior, fewer);
  }
}

// Of the most probable that hold 95 % together those that lack a reported effect.
std::vector<std::size_t> rivals_of(const Posterior& posterior, const Kinds& reported) {
  constexpr double held = 0.95;
  std::vector<std::size_t> out;
  double sum = 0.0;
  for (std::size_t i = 0; i < posterior.hypotheses.size() && sum < held; ++i) {
    sum += posterior.hypotheses[i].probability;
    if (!are_among(reported, posterior.hypotheses[i].effects)) out.push_back(i);
  }
  return out;
}

// For each reported effect the others that could replace it.
std::vector<Kinds> indistinguishable_sets(const Posterior& posterior, const Kinds& reported,
                                          const std::vector<std::size_t>& rivals) {
  std::vector<Kinds> sets;
  for (const EffectKind* kind : reported) {
    Kinds set{kind};
    for (const std::size_t rival : rivals) {
      const Kinds& there = posterior.hypotheses[rival].effects;
      if (has(there, kind)) continue;
      for (const EffectKind* other : there)
        if (!has(reported, other) && !has(set, other)) set.push_back(other);
    }
    if (set.size() > 1) sets.push_back(std::move(set));
  }
  return sets;
}

}  // namespace

std::string_view name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::no_missing_effect:
      return "no_missing_effect";
    case Verdict::declared_numbers_off:
      return "declared_numbers_off";
    case Verdict::explained:
      return "explained";
    case Verdict::partly_explained:
      return "partly_explained";
    case Verdict::unexplained:
      return "unexplained";
    case Verdict::incomplete:
      return "incomplete";
  }
  return "";
}

Answer answer_of(const Posterior& posterior, const Losses& losses) {
  Answer out{.reported = reported_of(posterior, 1.0 - least_probability(losses.false_name))};
  const WeighedHypothesis& reported = posterior.hypotheses[out.reported];
  out.rivals = rivals_of(posterior, reported.effects);
  out.indistinguishable = indistinguishable_sets(posterior, reported.effects, out.rivals);
  out.leaves_noise = reported.probability_of_noise >= least_probability(losses.false_noise);
  return out;
}

Verdict verdict_of(const Posterior& posterior, const Answer& answer, bool numbers_are_off) {
  if (!posterior.hypotheses[answer.reported].effects.empty())
    return answer.leaves_noise ? Verdict::explained : Verdict::partly_explained;
  if (!answer.leaves_noise) return Verdict::unexplained;
  return numbers_are_off ? Verdict::declared_numbers_off : Verdict::no_missing_effect;
}

}  // namespace coilwright::measurement::identification
