#include "measurement/compare/select_hypothesis.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <span>
#include <utility>

#include "measurement/compare/effect_strength.hpp"

namespace coilwright::measurement::compare {
namespace {

using actuator::Effect;
using actuator::EffectKind;
using Kinds = std::vector<const EffectKind*>;

// A gain of the criterion by less than this decides nothing: odds of 20 to 1 (Kass and Raftery 1995, "strong").
constexpr double decisive = 6.0;

bool contains(const Kinds& all, const EffectKind* one) {
  return std::ranges::find(all, one) != all.end();
}

// An effect that ended where it is not there explains nothing.
bool has_an_absent_effect(const Scored& s) {
  return std::ranges::any_of(s.hypothesis.effects_at(s.fit.values), is_absent);
}

template <typename Rule, typename Weigh>
void rule_out(std::vector<Scored>& all, const char* remark, std::vector<Candidate>& candidates, Rule&& rule,
              Weigh&& weigh) {
  std::erase_if(all, [&](const Scored& s) {
    if (!rule(s)) return false;
    candidates.push_back({.effects = s.kinds(), .evidence = weigh(s), .remark = remark});
    return true;
  });
}

// The choice, and the way to it: at each step the effect that by itself explains most of what is left.
void add_steps(std::span<const replay::Record> records, Scored chosen, std::vector<Scored>& steps) {
  std::vector<Effect> left = chosen.hypothesis.effects_at(chosen.fit.values);
  while (left.size() > 1) {
    std::optional<Scored> best;
    std::size_t which = 0;
    for (std::size_t i = 0; i < left.size(); ++i) {
      auto one = fitted_to_end(records, with(steps.back(), std::span(&left[i], 1)));
      if (one && (!best || one->fit.chi_square < best->fit.chi_square)) {
        best = std::move(one);
        which = i;
      }
    }
    if (!best) break;
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(which));
    steps.push_back(std::move(*best));
  }
  // The last step is the choice itself, its effects in the order of the steps.
  if (left.size() == 1 && steps.size() > 1) {
    if (auto last = fitted_to_end(records, with(steps.back(), left));
        last && last->fit.chi_square <= chosen.fit.chi_square * (1 + 1e-6)) {
      steps.push_back(std::move(*last));
      return;
    }
  }
  steps.push_back(std::move(chosen));
}

// For each effect of the choice the others that could stand in its place.
std::vector<Kinds> sets_of(const Kinds& chosen, const std::vector<Scored>& rivals) {
  std::vector<Kinds> sets;
  for (const EffectKind* kind : chosen) {
    Kinds set{kind};
    for (const Scored& rival : rivals) {
      const Kinds kinds = rival.kinds();
      if (contains(kinds, kind)) continue;
      for (const EffectKind* other : kinds)
        if (!contains(chosen, other) && !contains(set, other)) set.push_back(other);
    }
    if (set.size() > 1) sets.push_back(std::move(set));
  }
  return sets;
}

}  // namespace

void choose(std::span<const replay::Record> records, std::vector<Scored> all, Attribution& out) {
  const Scored& before = out.before();
  const auto weigh = [&](const Scored& s) { return evidence(records, before, s, out.unit); };
  rule_out(all, "fits best where it is absent", out.candidates, has_an_absent_effect, weigh);
  // What is no better than the same model without it was not improved by any of its starts.
  rule_out(
      all, "fits no better than without it", out.candidates,
      [&](const Scored& s) { return s.fit.chi_square > before.fit.chi_square * (1.0 + 1e-9); }, weigh);
  const auto against = [&](const Scored& s) { return criterion(s, out.unit); };
  std::ranges::stable_sort(all, {}, against);
  std::vector<Candidate> ranked;
  for (const Scored& s : all) ranked.push_back({.effects = s.kinds(), .evidence = weigh(s)});
  out.candidates.insert(out.candidates.begin(), ranked.begin(), ranked.end());
  if (all.empty() || against(before) - against(all.front()) < decisive) return;

  // Of all that come within a decisive gain of the best: the simplest.
  const double limit = against(all.front()) + decisive;
  std::vector<Scored> rivals;
  for (Scored& s : all)
    if (against(s) <= limit) rivals.push_back(std::move(s));
  const auto simplest = std::ranges::min_element(
      rivals, {}, [](const Scored& s) { return std::pair(s.hypothesis.effects().size(), s.hypothesis.size()); });
  Scored chosen = std::move(*simplest);
  rivals.erase(simplest);
  // A rival that is more than the choice and something on top is not another explanation.
  const Kinds kinds = chosen.kinds();
  std::erase_if(rivals, [&](const Scored& s) {
    const Kinds others = s.kinds();
    return std::ranges::all_of(kinds, [&](const EffectKind* kind) { return contains(others, kind); });
  });
  add_steps(records, std::move(chosen), out.steps);
  out.rivals = std::move(rivals);
  out.indistinguishable = sets_of(out.after().kinds(), out.rivals);
}

}  // namespace coilwright::measurement::compare
