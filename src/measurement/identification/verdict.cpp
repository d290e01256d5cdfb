#include "coilwright/measurement/identification/verdict.hpp"

#include <algorithm>
#include <iterator>
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
// to their tolerances have them: it leaves noise, or hardly more of what no hypothesis takes away.
bool is_enough(const Posterior& posterior, const WeighedHypothesis& hypothesis, const Losses& losses) {
  constexpr double negligible = decision_thresholds.least_over_noise * decision_thresholds.least_over_noise;
  const WeighedHypothesis& best = posterior.hypotheses.front();
  const double noise = least_probability(losses.false_noise);
  if (best.probability_of_noise < noise)
    return (1.0 - decision_thresholds.least_share) * hypothesis.chi_square <= best.chi_square;
  return hypothesis.chi_square <= (1.0 + negligible) * best.chi_square && hypothesis.probability_of_noise >= noise &&
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

constexpr double held = 0.95;

// Of the most probable that hold 95 % together those that lack a reported effect.
// What only adds effects to another rival is none of its own.
std::vector<std::size_t> rivals_of(const Posterior& posterior, const Kinds& reported) {
  std::vector<std::size_t> all;
  double sum = 0.0;
  for (std::size_t i = 0; i < posterior.hypotheses.size() && sum < held; ++i) {
    sum += posterior.hypotheses[i].probability;
    if (!are_among(reported, posterior.hypotheses[i].effects)) all.push_back(i);
  }
  std::vector<std::size_t> out;
  std::ranges::copy_if(all, std::back_inserter(out), [&](std::size_t one) {
    const Kinds& effects = posterior.hypotheses[one].effects;
    return std::ranges::none_of(all, [&](std::size_t other) {
      const Kinds& fewer = posterior.hypotheses[other].effects;
      return !fewer.empty() && fewer.size() < effects.size() && are_among(fewer, effects);
    });
  });
  return out;
}

// The effect that most of the probability of some hypotheses has, beside reported ones; null where none has anything.
const EffectKind* most_common(const std::vector<const WeighedHypothesis*>& among, const Kinds& reported,
                              double& probability) {
  Posterior some;
  for (const WeighedHypothesis* each : among) some.hypotheses.push_back(*each);
  for (const Posterior::Inclusion& each : some.effects())
    for (const WeighedHypothesis* hypothesis : among)
      for (const EffectKind* kind : hypothesis->effects)
        if (kind->id() == each.effect && !has(reported, kind)) {
          probability = each.probability;
          return kind;
        }
  return nullptr;
}

// For each reported effect the others that could be there in its place: as few as leave next to nothing to hypotheses
// with neither. What only accompanies another in them replaces nothing.
std::vector<Kinds> indistinguishable_sets(const Posterior& posterior, const Kinds& reported) {
  std::vector<Kinds> sets;
  for (const EffectKind* kind : reported) {
    Kinds set{kind};
    while (true) {
      std::vector<const WeighedHypothesis*> without_any;
      for (const WeighedHypothesis& each : posterior.hypotheses)
        if (std::ranges::none_of(set, [&](const EffectKind* one) { return has(each.effects, one); }))
          without_any.push_back(&each);
      double held_there = 0.0;
      const EffectKind* next = most_common(without_any, reported, held_there);
      if (next == nullptr || held_there < 1.0 - held) break;
      set.push_back(next);
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
  out.indistinguishable = indistinguishable_sets(posterior, reported.effects);
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
