#include "measurement/compare/select_hypothesis.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "coilwright/measurement/compare/decision_thresholds.hpp"
#include "measurement/compare/effect_strength.hpp"
#include "measurement/compare/staged_fit.hpp"

namespace coilwright::measurement::compare {
namespace {

using actuator::Effect;
using actuator::EffectKind;
using Kinds = std::vector<const EffectKind*>;

bool contains(const Kinds& all, const EffectKind* one) {
  return std::ranges::find(all, one) != all.end();
}

// An effect whose fit ended where it is absent explains nothing.
bool has_an_absent_effect(const FittedHypothesis& fitted) {
  return std::ranges::any_of(fitted.hypothesis.effects_at(fitted.fit.values), is_absent);
}

// Whether a hypothesis has just these effects, perhaps with fewer or further numbers.
bool has_just(const FittedHypothesis& fitted, const std::vector<Effect>& effects) {
  const Kinds kinds = fitted.kinds();
  return kinds.size() == effects.size() && std::ranges::all_of(effects, [&](const Effect& effect) {
           return std::ranges::any_of(kinds, [&](const EffectKind* kind) { return kind->id() == effect.kind->id(); });
         });
}

// Whether a hypothesis is the other one with fewer numbers of some of its effects.
bool is_with_fewer_numbers(const FittedHypothesis& smaller, const FittedHypothesis& larger) {
  return smaller.hypothesis.size() < larger.hypothesis.size() && has_just(smaller, larger.hypothesis.effects());
}

// From the declared model to the selected hypothesis: each step adds the effect that by itself explains most of the
// remainder. A step that the search has fitted better than can be done from here, from whatever start, is that fit:
// what comes after it must not be credited with what a poor fit leaves over.
std::vector<FittedHypothesis> steps_to(FittedHypothesis selected, std::span<const replay::PreparedRun> runs,
                                       const FittedHypothesis& declared, const std::vector<FittedHypothesis>& all) {
  std::vector<FittedHypothesis> out;
  const auto last_step = [&]() -> const FittedHypothesis& { return out.empty() ? declared : out.back(); };
  std::vector<Effect> left = selected.hypothesis.effects_at(selected.fit.values);
  std::vector<Effect> taken;
  while (left.size() > 1) {
    std::optional<FittedHypothesis> best;
    std::size_t index = 0;
    const auto consider = [&](const FittedHypothesis& one, std::size_t i) {
      if (best && one.fit.objective() >= best->fit.objective()) return;
      best = one;
      index = i;
    };
    std::vector<std::optional<FittedHypothesis>> alone(left.size());
    tbb::parallel_for(std::size_t{0}, left.size(), [&](std::size_t i) {
      alone[i] = fit_to_convergence(runs, with_added_effects(last_step(), std::span(&left[i], 1)));
    });
    for (std::size_t i = 0; i < left.size(); ++i) {
      if (alone[i]) consider(*alone[i], i);
      std::vector<Effect> these = taken;
      these.push_back(left[i]);
      for (const FittedHypothesis& known : all)
        if (has_just(known, these)) consider(known, i);
    }
    if (!best) break;
    taken.push_back(left[index]);
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(index));
    out.push_back(std::move(*best));
  }
  // The last step is the selected hypothesis itself, with its effects in the order of the steps.
  if (left.size() == 1 && !out.empty()) {
    auto last = fit_to_convergence(runs, with_added_effects(last_step(), left));
    if (last && last->fit.objective() <= selected.fit.objective() * (1 + 1e-6)) {
      out.push_back(std::move(*last));
      return out;
    }
  }
  out.push_back(std::move(selected));
  return out;
}

// For each selected effect the others that could replace it.
std::vector<Kinds> indistinguishable_sets(const Kinds& selected, const std::vector<FittedHypothesis>& rivals) {
  std::vector<Kinds> sets;
  for (const EffectKind* kind : selected) {
    Kinds set{kind};
    for (const FittedHypothesis& rival : rivals) {
      const Kinds kinds = rival.kinds();
      if (contains(kinds, kind)) continue;
      for (const EffectKind* other : kinds)
        if (!contains(selected, other) && !contains(set, other)) set.push_back(other);
    }
    if (set.size() > 1) sets.push_back(std::move(set));
  }
  return sets;
}

}  // namespace

Selection select_hypothesis(std::span<const replay::PreparedRun> runs, const FittedHypothesis& declared,
                            std::vector<FittedHypothesis> all, double overdispersion) {
  Selection out;
  const auto evidence_of = [&](const FittedHypothesis& fitted) {
    return evidence_between(runs, declared, fitted, overdispersion);
  };
  const auto rule_out = [&](const std::string& remark, const auto& rule) {
    std::vector<char> applies;
    for (const FittedHypothesis& fitted : all) applies.push_back(rule(fitted));
    std::vector<FittedHypothesis> kept;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (applies[i] == 0)
        kept.push_back(std::move(all[i]));
      else
        out.ruled_out.push_back({.effects = all[i].kinds(), .evidence = evidence_of(all[i]), .remark = remark});
    }
    all = std::move(kept);
  };
  rule_out("fits best where it is absent", has_an_absent_effect);
  // No start of such a hypothesis improved on the same model without its effects.
  rule_out("fits no better than without it", [&](const FittedHypothesis& fitted) {
    return fitted.fit.objective() > declared.fit.objective() * (1.0 + 1e-9);
  });
  // Further numbers of an effect are judged as a further effect is.
  rule_out("its further numbers explain too little of what is left over", [&](const FittedHypothesis& fitted) {
    if (fitted.whiteness.is_white()) return false;
    return std::ranges::any_of(all, [&](const FittedHypothesis& smaller) {
      return is_with_fewer_numbers(smaller, fitted) &&
             fitted.chi_square_above_noise() >
                 (1.0 - decision_thresholds.least_explained_later) * smaller.chi_square_above_noise();
    });
  });
  const auto bic = [&](const FittedHypothesis& fitted) { return quasi_bic(fitted, overdispersion); };
  std::ranges::stable_sort(all, {}, bic);
  for (const FittedHypothesis& fitted : all)
    out.ranked.push_back({.effects = fitted.kinds(), .evidence = evidence_of(fitted)});
  if (all.empty() || bic(declared) - bic(all.front()) < decision_thresholds.decisive_gain) return out;

  // The simplest of those within a decisive gain of the best.
  const double limit = bic(all.front()) + decision_thresholds.decisive_gain;
  std::vector<FittedHypothesis> rivals;
  for (const FittedHypothesis& fitted : all)
    if (bic(fitted) <= limit) rivals.push_back(fitted);
  const auto simplest = std::ranges::min_element(rivals, {}, [](const FittedHypothesis& fitted) {
    return std::pair(fitted.hypothesis.effects().size(), fitted.hypothesis.size());
  });
  FittedHypothesis selected = *simplest;
  rivals.erase(simplest);
  // A rival that contains all selected effects, if with further numbers, is not another explanation.
  const Kinds kinds = selected.kinds();
  std::erase_if(rivals, [&](const FittedHypothesis& rival) {
    const Kinds others = rival.kinds();
    return std::ranges::all_of(kinds, [&](const EffectKind* kind) {
      return std::ranges::any_of(others, [&](const EffectKind* other) { return other->id() == kind->id(); });
    });
  });
  out.steps = steps_to(std::move(selected), runs, declared, all);
  out.rivals = std::move(rivals);
  out.indistinguishable = indistinguishable_sets(out.steps.back().kinds(), out.rivals);
  return out;
}

}  // namespace coilwright::measurement::compare
