#include "measurement/identification/settled_fits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <iterator>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>

#include "coilwright/measurement/identification/decision_thresholds.hpp"
#include "measurement/fit/parallel.hpp"
#include "measurement/identification/effect_strength.hpp"
#include "measurement/identification/fit_in_turns.hpp"
#include "measurement/identification/model_error.hpp"
#include "measurement/identification/posterior.hpp"
#include "measurement/identification/search_effort.hpp"
#include "measurement/identification/staged_fit.hpp"
#include "measurement/identification/weighed_fit.hpp"

namespace coilwright::measurement::identification {
namespace {

using actuator::Effect;
using actuator::EffectKind;
using Effects = std::vector<Effect>;

// A fit and what it weighs.
struct Entry {
  FittedHypothesis fitted;
  WeighedFit weighed{};
  bool at_optimum{};
};

std::vector<std::string_view> ids_of_effects(const Effects& effects) {
  std::vector<std::string_view> out;
  for (const Effect& each : effects) out.push_back(each.kind->id());
  std::ranges::sort(out);
  return out;
}

std::vector<std::string_view> ids_of_entry(const Entry& entry) {
  return ids_of(entry.fitted.kinds());
}

bool is_of(const Effects& effects, std::string_view id) {
  return std::ranges::any_of(effects, [&](const Effect& each) { return each.kind->id() == id; });
}

// "ms" of "delay_ms"; empty where an effect has no number, or one without a unit.
std::string_view unit_of_first_number(const EffectKind& kind) {
  if (kind.parameters().empty()) return {};
  const std::string_view key = kind.parameters().front().key;
  const std::size_t at = key.find('_');
  return at == std::string_view::npos ? std::string_view{} : key.substr(at + 1);
}

// What a further fall of the objective means nothing to.
double negligible_fall(const FittedHypothesis& fitted) {
  constexpr double near_noise = 0.1;
  constexpr double far_from_noise = 1e-3;
  return is_far_from_noise(fitted) ? far_from_noise * fitted.fit.objective() : near_noise;
}

bool is_at_optimum(const FittedHypothesis& fitted) {
  return promised_fall(fitted.fit) <= negligible_fall(fitted);
}

// The rise of the objective from a fit to a place, as its derivatives predict it.
double predicted_rise(const FittedHypothesis& fitted, const Eigen::VectorXd& place) {
  const Eigen::VectorXd way = place - fitted.fit.values;
  return way.dot(fitted.fit.normal_matrix * way);
}

// A fit that is to be made.
struct Start {
  PlannedFit plan;
  const Entry* target{};     // the best fit of the same hypothesis; null: there is none
  const Entry* reference{};  // whose numbers it starts from
  double objective = std::numeric_limits<double>::infinity();
  std::optional<fit::Fit> fitted{};
  bool goes_on = false;  // from the end of the target's own fit, which is not at an optimum
};

class FitsToSettle {
 public:
  FitsToSettle(const Settling& with, std::vector<FittedHypothesis> fits) : with_(with) {
    for (FittedHypothesis& each : fits) entries_.push_back({.fitted = std::move(each)});
    weigh_from(0);
  }

  std::vector<FittedHypothesis> run() {
    constexpr int most_rounds = 4;
    for (int round = 0; round < most_rounds; ++round)
      if (!improve(starts())) break;
    return result();
  }

 private:
  void weigh_from(std::size_t first) {
    fit::in_parallel(entries_.size() - first, [&](std::size_t i) {
      Entry& entry = entries_[first + i];
      entry.weighed = weighed(with_.runs, entry.fitted, with_.scale);
      entry.at_optimum = is_at_optimum(entry.fitted);
    });
  }

  [[nodiscard]] double log_weight(const Entry& entry) const {
    return share_ * entry.weighed.log_evidence + log_prior(entry.fitted.kinds(), with_.kinds, with_.beliefs);
  }

  // Of two fits of one hypothesis. What is not at an optimum weighs nothing beside what is lower.
  [[nodiscard]] bool is_better(const Entry& one, const Entry& other) const {
    const bool lower = one.fitted.fit.objective() < other.fitted.fit.objective();
    if (!(lower ? other : one).at_optimum) return lower;
    return log_weight(one) > log_weight(other);
  }

  // The best fit of each hypothesis, the heaviest first.
  [[nodiscard]] std::vector<const Entry*> hypotheses() {
    std::vector<const Entry*> out;
    for (const Entry& each : entries_) {
      const auto known =
          std::ranges::find_if(out, [&](const Entry* one) { return ids_of_entry(*one) == ids_of_entry(each); });
      if (known == out.end())
        out.push_back(&each);
      else if (is_better(each, **known))
        *known = &each;
    }
    std::ranges::stable_sort(out, std::ranges::greater{}, [&](const Entry* each) { return log_weight(*each); });
    return out;
  }

  [[nodiscard]] const Entry* best_of(const std::vector<const Entry*>& hypotheses,
                                     const std::vector<std::string_view>& ids) const {
    const auto found = std::ranges::find_if(hypotheses, [&](const Entry* each) { return ids_of_entry(*each) == ids; });
    return found == hypotheses.end() ? nullptr : *found;
  }

  // `effects` from where `from` is: numbers of effects that it has as it has them, others as they come.
  void add_start(std::vector<Start>& out, Effects effects, const Entry& from, const Entry* target) {
    const Effects there = from.fitted.hypothesis.effects_at(from.fitted.fit.values);
    for (Effect& each : effects)
      for (const Effect& known : there)
        if (known.kind == each.kind) each = known;
    PlannedFit plan{.hypothesis = fit::Hypothesis(from.fitted.hypothesis.declared(), std::move(effects)),
                    .local_numbers_from = &from.fitted.fit,
                    .derivatives_from = &from.fitted.fit};
    plan.start = plan.hypothesis.start();
    const auto declared = static_cast<Eigen::Index>(from.fitted.hypothesis.declared().calibration.size());
    plan.start.head(declared) = from.fitted.fit.values.head(declared);
    add(out, {.plan = std::move(plan), .target = target, .reference = &from});
  }

  void go_on(std::vector<Start>& out, const Entry& entry) {
    PlannedFit plan{.hypothesis = entry.fitted.hypothesis,
                    .start = entry.fitted.fit.values,
                    .local_numbers_from = &entry.fitted.fit,
                    .derivatives_from = &entry.fitted.fit};
    add(out, {.plan = std::move(plan), .target = &entry, .reference = &entry, .goes_on = true});
  }

  // Unless it leads back, or was tried.
  void add(std::vector<Start>& out, Start start) {
    constexpr double nothing = 1.0;  // of chi-square
    const std::vector<Effect>& effects = start.plan.hypothesis.effects();
    // Choices, which are no parameters, tell hypotheses of one set apart.
    if (!start.goes_on && start.target != nullptr &&
        start.target->fitted.hypothesis.size() == start.plan.hypothesis.size() &&
        have_same_choices(effects, start.target->fitted.hypothesis.effects()) &&
        predicted_rise(start.target->fitted, start.plan.start) < nothing)
      return;
    const auto is_tried = [&](const Tried& each) {
      return each.ids == ids_of_effects(effects) && each.place.size() == start.plan.start.size() &&
             each.place == start.plan.start;
    };
    if (std::ranges::any_of(tried_, is_tried)) return;
    tried_.push_back({.ids = ids_of_effects(effects), .place = start.plan.start});
    out.push_back(std::move(start));
  }

  static bool have_same_choices(const Effects& one, const Effects& other) {
    return std::ranges::equal(one, other, [](const Effect& a, const Effect& b) {
      if (a.kind != b.kind) return false;
      for (std::size_t i = 0; i < a.values.size(); ++i)
        if (!a.kind->parameters()[i].choices.empty() && a.values[i] != b.values[i]) return false;
      return true;
    });
  }

  [[nodiscard]] Effects effects_of(const Entry& entry) const {
    return entry.fitted.hypothesis.effects_at(entry.fitted.fit.values);
  }

  std::vector<Start> starts() {
    std::vector<const Entry*> all = hypotheses();
    share_ = share_of_evidence(all.front()->weighed);
    all = hypotheses();
    best_ = log_weight(*all.front());
    std::vector<const Entry*> heavy;
    for (const Entry* each : all)
      if (heavy.size() < search_effort.heaviest && log_weight(*each) >= best_ + std::log(search_effort.least_weight))
        heavy.push_back(each);
    std::vector<const Entry*> targets = heavy;
    const Entry* without = best_of(all, {});
    if (std::ranges::find(targets, without) == targets.end()) targets.push_back(without);
    std::vector<Start> out;
    for (const Entry* target : targets)
      if (!target->at_optimum) go_on(out, *target);
    for (const Entry* target : targets)
      for (const Entry* from : targets)
        if (from != target) add_start(out, effects_of(*target), *from, target);
    for (const Entry* from : heavy) {
      const Effects effects = effects_of(*from);
      for (std::size_t e = 0; e < effects.size(); ++e) {
        Effects fewer = effects;
        fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(e));
        add_start(out, fewer, *from, best_of(all, ids_of_effects(fewer)));
        for (Effect& other : exchanged(effects[e])) {
          if (is_of(effects, other.kind->id())) continue;
          Effects rival = effects;
          rival[e] = std::move(other);
          add_start(out, rival, *from, best_of(all, ids_of_effects(rival)));
        }
      }
    }
    for (const Entry* target : all)
      for (const Entry* from : heavy) add_absent(out, *target, *from);
    add_known(out, all, *without);
    return out;
  }

  // What is worse than a hypothesis with fewer effects, which it can do whatever these can, is at no optimum: it starts
  // there, with what it has more next to absent.
  void add_absent(std::vector<Start>& out, const Entry& target, const Entry& from) {
    const double worse = target.fitted.fit.objective() - from.fitted.fit.objective();
    if (worse < decision_thresholds.decisive_gain || target.fitted.kinds().size() <= from.fitted.kinds().size() ||
        !are_among(from.fitted.kinds(), target.fitted.kinds()))
      return;
    Effects effects = effects_of(target);
    for (Effect& each : effects) each = scaled_from_absent(std::move(each), search_effort.retry_strength);
    add_start(out, std::move(effects), from, &target);
  }

  // Other effects with a number of the same kind, which takes over the value.
  [[nodiscard]] Effects exchanged(const Effect& effect) const {
    Effects out;
    const std::string_view unit = unit_of_first_number(*effect.kind);
    if (unit.empty()) return out;
    for (const EffectKind* kind : with_.tested) {
      if (kind->id() == effect.kind->id() || unit_of_first_number(*kind) != unit) continue;
      Effect other{.kind = kind, .values = kind->starts(with_.scale).front()};
      const actuator::EffectParameter& number = kind->parameters().front();
      if (!number.choices.empty()) continue;
      other.values.front() = std::clamp(effect.values.front(), number.lower, number.upper);
      out.push_back(std::move(other));
    }
    return out;
  }

  void add_known(std::vector<Start>& out, const std::vector<const Entry*>& all, const Entry& without) {
    const auto is_tested = [&](const Effect& effect) {
      return std::ranges::any_of(with_.tested, [&](const EffectKind* kind) { return kind->id() == effect.kind->id(); });
    };
    for (const KnownPlace& each : with_.known) {
      if (!std::ranges::all_of(each.effects, is_tested)) continue;
      PlannedFit plan{.hypothesis = fit::Hypothesis(without.fitted.hypothesis.declared(), each.effects),
                      .start = each.values};
      add(out, {.plan = std::move(plan), .target = best_of(all, ids_of_effects(each.effects)), .reference = &without});
    }
  }

  // The weight that a start promises with such an objective, from what is known of its own hypothesis, or of the one
  // whose numbers it takes over.
  [[nodiscard]] double promise(const Start& start, double objective) const {
    const Entry& known = start.target != nullptr ? *start.target : *start.reference;
    std::vector<const EffectKind*> kinds;
    for (const Effect& each : start.plan.hypothesis.effects()) kinds.push_back(each.kind);
    return log_weight(known) + log_prior(kinds, with_.kinds, with_.beliefs) -
           log_prior(known.fitted.kinds(), with_.kinds, with_.beliefs) +
           0.5 * share_ * (known.fitted.fit.objective() - objective);
  }

  // Whether the objective there is as the derivatives of the target's own fit predict it.
  static bool leads_back(const Start& start) {
    constexpr double nearly = 0.5;
    if (start.goes_on || start.target == nullptr ||
        start.target->fitted.hypothesis.size() != start.plan.hypothesis.size() ||
        !have_same_choices(start.plan.hypothesis.effects(), start.target->fitted.hypothesis.effects()))
      return false;
    const double rise = predicted_rise(start.target->fitted, start.plan.start);
    return std::abs(start.objective - start.target->fitted.fit.objective() - rise) < nearly * rise;
  }

  // Fits from the starts, and whether that led anywhere.
  bool improve(std::vector<Start> starts) {
    fit::in_parallel(starts.size(), [&](std::size_t i) {
      fit::FitRequest request = fit_request_of(with_.runs, starts[i].plan);
      const auto there = fit::evaluate_at(request);
      if (there) starts[i].objective = there->objective();
    });
    std::erase_if(starts, [](const Start& each) { return std::isinf(each.objective) || leads_back(each); });
    starts = lowest_of_each(std::move(starts), search_effort.settling_starts);
    fit::in_parallel(starts.size(), [&](std::size_t i) {
      fit::FitRequest request = fit_request_of(with_.runs, starts[i].plan);
      const Entry& known = starts[i].target != nullptr ? *starts[i].target : *starts[i].reference;
      request.effort = ends_by_what_is_left(search_effort.short_fit, known.fitted);
      starts[i].fitted = fit::fit(request);
      starts[i].objective = starts[i].fitted ? starts[i].fitted->objective() : std::numeric_limits<double>::infinity();
    });
    std::erase_if(starts, [&](const Start& each) { return !is_worth_its_end(each); });
    starts = lowest_of_each(std::move(starts), 1);
    std::vector<std::optional<FittedHypothesis>> found(starts.size());
    fit::in_parallel(starts.size(), [&](std::size_t i) {
      found[i] = fit_exactly(with_.runs, {.hypothesis = starts[i].plan.hypothesis,
                                          .start = starts[i].fitted->values,
                                          .local_numbers_from = &*starts[i].fitted,
                                          .derivatives_from = &*starts[i].fitted});
    });
    const std::size_t first = entries_.size();
    std::size_t better = 0;
    for (std::size_t i = 0; i < starts.size(); ++i) {
      if (!found[i]) continue;
      const Entry* target = starts[i].target;
      if (target != nullptr &&
          found[i]->fit.objective() > target->fitted.fit.objective() - negligible_fall(target->fitted) &&
          predicted_rise_or_infinite(*target, *found[i]) < 1.0)
        continue;
      ++better;
      entries_.push_back({.fitted = std::move(*found[i])});
    }
    weigh_from(first);
    if (better > 0 && with_.progress)
      with_.progress(fmt::format("{} fit{} found from where others are", better, better == 1 ? "" : "s"));
    return better > 0;
  }

  static double predicted_rise_or_infinite(const Entry& target, const FittedHypothesis& there) {
    return target.fitted.fit.values.size() == there.fit.values.size() ? predicted_rise(target.fitted, there.fit.values)
                                                                      : std::numeric_limits<double>::infinity();
  }

  [[nodiscard]] bool is_worth_its_end(const Start& start) const {
    if (!start.fitted || promise(start, start.objective) < best_ + std::log(search_effort.least_weight)) return false;
    return start.target == nullptr ||
           start.objective <= start.target->fitted.fit.objective() + decision_thresholds.decisive_gain;
  }

  static std::vector<Start> lowest_of_each(std::vector<Start> starts, std::size_t most) {
    std::ranges::stable_sort(starts, {}, &Start::objective);
    std::vector<Start> out;
    for (Start& each : starts) {
      const auto ids = ids_of_effects(each.plan.hypothesis.effects());
      const auto before = std::ranges::count_if(
          out, [&](const Start& one) { return ids_of_effects(one.plan.hypothesis.effects()) == ids; });
      if (static_cast<std::size_t>(before) < most) out.push_back(std::move(each));
    }
    return out;
  }

  // The most probable fit without effects first, then all with effects.
  std::vector<FittedHypothesis> result() {
    const Entry* without = best_of(hypotheses(), {});
    std::vector<FittedHypothesis> out{without->fitted};
    std::vector<const Entry*> sorted;
    for (const Entry& each : entries_) sorted.push_back(&each);
    std::ranges::stable_sort(sorted, std::ranges::greater{}, [&](const Entry* each) { return log_weight(*each); });
    for (const Entry* place : sorted) {
      const Entry& each = *place;
      if (each.fitted.hypothesis.effects().empty()) continue;
      const bool weighs_nothing = !each.at_optimum && std::ranges::any_of(entries_, [&](const Entry& other) {
        return &other != &each && ids_of_entry(other) == ids_of_entry(each) && is_better(other, each);
      });
      if (!weighs_nothing) out.push_back(each.fitted);
    }
    return out;
  }

  struct Tried {
    std::vector<std::string_view> ids;
    Eigen::VectorXd place;
  };

  const Settling& with_;
  std::deque<Entry> entries_;  // which stay where they are: starts refer to them
  std::vector<Tried> tried_;
  double share_ = 1.0;
  double best_ = 0.0;
};

}  // namespace

std::vector<FittedHypothesis> settled(const Settling& with, std::vector<FittedHypothesis> fits) {
  return FitsToSettle(with, std::move(fits)).run();
}

}  // namespace coilwright::measurement::identification
