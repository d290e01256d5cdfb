#include "coilwright/measurement/identification/verdict.hpp"

#include <algorithm>
#include <optional>

#include "coilwright/measurement/identification/decision_thresholds.hpp"

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

std::size_t most_probable_among(const Posterior& posterior, const Kinds& effects) {
  const auto found = std::ranges::find_if(
      posterior.hypotheses, [&](const WeighedHypothesis& each) { return are_among(each.effects, effects); });
  return static_cast<std::size_t>(found - posterior.hypotheses.begin());
}

// Whether a hypothesis does as well as the most probable one for all that anyone would see, with numbers as rigs built
// to their tolerances have them.
bool is_enough(const Posterior& posterior, const WeighedHypothesis& hypothesis, const Losses& losses) {
  constexpr double negligible = decision_thresholds.least_over_noise * decision_thresholds.least_over_noise;
  return hypothesis.chi_square <= (1.0 + negligible) * posterior.hypotheses.front().chi_square &&
         hypothesis.probability_of_noise >= least_probability(losses.false_noise) &&
         hypothesis.probability_of_declared >= decision_thresholds.least_probability;
}

// The most probable hypothesis that does without one of these effects; nothing where each is to be named.
std::optional<std::size_t> without_one_of(const Posterior& posterior, const Kinds& effects, const Losses& losses) {
  std::optional<std::size_t> out;
  double probability = 0.0;
  for (std::size_t i = 0; i < effects.size(); ++i) {
    const Kinds fewer = without(effects, i);
    const std::size_t place = most_probable_among(posterior, fewer);
    const double there = posterior.probability_among(fewer);
    if (there <= 1.0 - least_probability(losses.false_name) &&
        !is_enough(posterior, posterior.hypotheses[place], losses))
      continue;
    if (out && there <= probability) continue;
    out = place;
    probability = there;
  }
  return out;
}

std::size_t reported_of(const Posterior& posterior, const Losses& losses) {
  std::size_t out = 0;
  while (const auto fewer = without_one_of(posterior, posterior.hypotheses[out].effects, losses)) out = *fewer;
  return out;
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
  Answer out{.reported = reported_of(posterior, losses)};
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
