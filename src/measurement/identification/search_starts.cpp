#include "measurement/identification/search_starts.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "coilwright/measurement/identification/decision_thresholds.hpp"
#include "measurement/identification/effect_strength.hpp"
#include "measurement/identification/hypothesis_extension.hpp"
#include "measurement/identification/joint_screening.hpp"
#include "measurement/identification/model_error.hpp"
#include "measurement/identification/other_optima.hpp"
#include "measurement/identification/prior_of_numbers.hpp"
#include "measurement/identification/reached_limits.hpp"
#include "measurement/identification/search_effort.hpp"

namespace coilwright::measurement::identification {
namespace {

using actuator::Effect;
using actuator::EffectKind;
using Effects = std::vector<Effect>;

std::vector<const EffectKind*> kinds_of(const Effects& effects) {
  std::vector<const EffectKind*> out;
  for (const Effect& each : effects) out.push_back(each.kind);
  return out;
}

std::vector<std::string_view> ids_of_effects(const Effects& effects) {
  return ids_of(kinds_of(effects));
}

Effects effects_of(const TableEntry& entry) {
  return entry.fitted.hypothesis.effects_at(entry.fitted.fit.values);
}

bool has(const Effects& effects, const EffectKind* kind) {
  return are_among({kind}, kinds_of(effects));
}

// "ms" of "delay_ms"; empty where an effect has no number, or one without a unit.
std::string_view unit_of_first_number(const EffectKind& kind) {
  if (kind.parameters().empty()) return {};
  const std::string_view key = kind.parameters().front().key;
  const std::size_t at = key.find('_');
  return at == std::string_view::npos ? std::string_view{} : key.substr(at + 1);
}

bool is_in(const std::vector<std::vector<std::string_view>>& all, const std::vector<std::string_view>& ids) {
  return std::ranges::find(all, ids) != all.end();
}

}  // namespace

bool make_same_choices(const Effects& one, const Effects& other) {
  return std::ranges::equal(
      one, other, [](const Effect& a, const Effect& b) { return a.kind == b.kind && choices_of(a) == choices_of(b); });
}

double predicted_rise(const FittedHypothesis& fitted, const Eigen::VectorXd& place) {
  const Eigen::VectorXd way = place - fitted.fit.values;
  return way.dot(fitted.fit.normal_matrix * way);
}

bool is_elsewhere_in(const Start& start) {
  return start.target != nullptr && start.target->fitted.hypothesis.size() == start.plan.hypothesis.size() &&
         make_same_choices(start.plan.hypothesis.effects(), start.target->fitted.hypothesis.effects());
}

std::vector<Start> SearchStarts::next() {
  all_ = table_.hypotheses();
  without_ = table_.best_of({});
  heavy_.clear();
  const std::size_t most = table_.leaves_noise() ? search_effort.heaviest : search_effort.heaviest_of_wrong;
  const double worth = table_.worth_a_fit();
  for (const TableEntry* each : all_)
    if (heavy_.size() < most && table_.log_weight(*each) >= worth) heavy_.push_back(each);
  std::vector<Start> out;
  add_from_others(out);
  for (const TableEntry* from : heavy_) add_fewer_or_exchanged(out, *from);
  for (const TableEntry* target : all_)
    for (const TableEntry* from : heavy_) add_next_to_absent(out, *target, *from);
  add_known(out);
  if (with_.extends) {
    add_other_optima(out);
    add_larger(out);
  }
  return out;
}

// Unless it leads back, or was tried.
void SearchStarts::add(std::vector<Start>& out, Start start) {
  constexpr double nothing = 1.0;  // of chi-square
  // Choices, which are no parameters, tell hypotheses of one set apart.
  if (is_elsewhere_in(start) && predicted_rise(start.target->fitted, start.plan.start) < nothing) return;
  Tried tried{.ids = ids_of_effects(start.plan.hypothesis.effects()), .place = start.plan.start};
  const auto is_tried = [&](const Tried& each) {
    return each.ids == tried.ids && each.place.size() == tried.place.size() && each.place == tried.place;
  };
  if (std::ranges::any_of(tried_, is_tried)) return;
  tried_.push_back(std::move(tried));
  out.push_back(std::move(start));
}

// `effects` from where `from` is: numbers of effects that it has as it has them, others as they come.
void SearchStarts::add_from(std::vector<Start>& out, Effects effects, const TableEntry& from,
                            const TableEntry* target) {
  for (const Effect& known : effects_of(from))
    for (Effect& each : effects)
      if (each.kind == known.kind) each = known;
  PlannedFit plan{.hypothesis = fit::Hypothesis(from.fitted.hypothesis.declared(), std::move(effects)),
                  .local_numbers_from = &from.fitted.fit,
                  .derivatives_from = &from.fitted.fit};
  plan.start = plan.hypothesis.start();
  const auto declared = static_cast<Eigen::Index>(from.fitted.hypothesis.declared().calibration.size());
  plan.start.head(declared) = from.fitted.fit.values.head(declared);
  add(out, {.plan = std::move(plan), .kind = StartKind::from_another, .target = target, .reference = &from});
}

void SearchStarts::add_from_others(std::vector<Start>& out) {
  std::vector<const TableEntry*> targets = heavy_;
  if (std::ranges::find(targets, without_) == targets.end()) targets.push_back(without_);
  for (const TableEntry* target : targets)
    for (const TableEntry* from : targets)
      if (from != target) add_from(out, effects_of(*target), *from, target);
}

void SearchStarts::add_fewer_or_exchanged(std::vector<Start>& out, const TableEntry& from) {
  const Effects effects = effects_of(from);
  for (std::size_t e = 0; e < effects.size(); ++e) {
    Effects fewer = effects;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(e));
    add_from(out, fewer, from, table_.best_of(ids_of_effects(fewer)));
    for (Effect& other : exchanged(effects[e])) {
      if (has(effects, other.kind)) continue;
      Effects rival = effects;
      rival[e] = std::move(other);
      add_from(out, rival, from, table_.best_of(ids_of_effects(rival)));
    }
  }
}

void SearchStarts::add_next_to_absent(std::vector<Start>& out, const TableEntry& target, const TableEntry& from) {
  const double worse = target.fitted.fit.objective() - from.fitted.fit.objective();
  if (worse < decision_thresholds.decisive_gain || target.fitted.kinds().size() <= from.fitted.kinds().size() ||
      !are_among(from.fitted.kinds(), target.fitted.kinds()))
    return;
  Effects effects = effects_of(target);
  for (Effect& each : effects) each = scaled_from_absent(std::move(each), search_effort.retry_strength);
  add_from(out, std::move(effects), from, &target);
}

// Other effects with a number of the same kind, which takes over the value.
Effects SearchStarts::exchanged(const Effect& effect) const {
  Effects out;
  const std::string_view unit = unit_of_first_number(*effect.kind);
  if (unit.empty()) return out;
  for (const EffectKind* kind : with_.tested) {
    if (kind->id() == effect.kind->id() || unit_of_first_number(*kind) != unit) continue;
    Effect other{.kind = kind, .values = kind->starts(table_.with().scale).front()};
    const actuator::EffectParameter& number = kind->parameters().front();
    if (!number.choices.empty()) continue;
    other.values.front() = std::clamp(effect.values.front(), number.lower, number.upper);
    out.push_back(std::move(other));
  }
  return out;
}

void SearchStarts::add_known(std::vector<Start>& out) {
  const auto is_tested = [&](const Effect& effect) {
    return std::ranges::any_of(with_.tested, [&](const EffectKind* kind) { return kind->id() == effect.kind->id(); });
  };
  for (const KnownPlace& each : with_.known) {
    if (!std::ranges::all_of(each.effects, is_tested)) continue;
    PlannedFit plan{.hypothesis = fit::Hypothesis(without_->fitted.hypothesis.declared(), each.effects),
                    .start = each.values};
    add(out, {.plan = std::move(plan),
              .kind = StartKind::from_another,
              .target = table_.best_of(ids_of_effects(each.effects)),
              .reference = without_});
  }
}

double SearchStarts::least_objective() const {
  double out = std::numeric_limits<double>::infinity();
  for (const TableEntry* each : all_) out = std::min(out, each->fitted.fit.objective());
  return out;
}

void SearchStarts::add_other_optima(std::vector<Start>& out) {
  const double least = least_objective();
  std::size_t place = 0;
  for (const TableEntry* each : all_) {
    if (each->fitted.hypothesis.effects().empty()) continue;
    const bool is_far = is_far_from_noise(each->fitted);
    if (!is_far && each->fitted.fit.objective() - least > search_effort.other_optima_gain) continue;
    if (!is_far) add_own(out, *each);
    if (place++ >= (table_.leaves_noise() || is_far ? search_effort.restarted : search_effort.reconsidered)) continue;
    if (is_in(reconsidered_, each->ids())) continue;
    reconsidered_.push_back(each->ids());
    std::vector<PlannedFit> plans = with_other_choices(each->fitted);
    const auto append = [&](std::vector<PlannedFit> more) { std::ranges::move(more, std::back_inserter(plans)); };
    append(with_other_starts(each->fitted, with_.seed));
    append(with_further_numbers(each->fitted, table_.with().scale));
    if (!is_far) append(from_reached_limits(table_.with().runs, each->fitted));
    for (PlannedFit& plan : plans)
      add(out, {.plan = std::move(plan), .kind = StartKind::other_optimum, .target = each, .reference = each});
  }
}

// Every single effect that is near, not the heaviest alone: the true one may have ended where others leave less. Those
// that explain next to nothing have begun there before (from_other_starts()), and where no effect is needed none can
// gain.
void SearchStarts::add_own(std::vector<Start>& out, const TableEntry& target) {
  const double explained = without_->fitted.fit.objective() - target.fitted.fit.objective();
  if (without_->weighed.probability_of_noise >= 0.5 ||
      explained < search_effort.next_to_nothing * without_->fitted.chi_square_above_noise())
    return;
  for (PlannedFit& plan : from_own_starts(target.fitted, table_.with().scale))
    add(out, {.plan = std::move(plan), .kind = StartKind::own, .target = &target, .reference = &target});
}

// The heaviest by what they promise, each hypothesis once.
void SearchStarts::add_larger(std::vector<Start>& out) {
  const bool leaves_noise = table_.leaves_noise();
  // What leaves noise cannot be explained better, only with more: that is tried once, and not where no effect is
  // needed.
  if (leaves_noise && (without_->weighed.probability_of_noise >= 0.5 || std::exchange(extended_noise_, true))) return;
  const double least = least_objective();
  std::size_t extended = 0;
  for (const TableEntry* each : all_) {
    if (extended == (leaves_noise ? search_effort.extended_from_noise : search_effort.extended)) break;
    const bool is_near =
        !is_far_from_noise(each->fitted) && each->fitted.fit.objective() - least <= search_effort.other_optima_gain;
    if (!is_near && std::ranges::find(heavy_, each) == heavy_.end()) continue;
    ++extended;
    screen_beside(*each, each == all_.front() && !leaves_noise && !is_far_from_noise(each->fitted));
  }
  screen_together();
  const auto promise = [&](const Candidate& each) {
    Effects effects = effects_of(*each.base);
    std::ranges::copy(each.effects, std::back_inserter(effects));
    return table_.promise(*each.base, kinds_of(effects), each.evidence);
  };
  const double worth = table_.worth_a_fit();
  std::ranges::stable_sort(candidates_, std::ranges::greater{}, promise);
  std::vector<std::vector<std::string_view>> taken;
  std::vector<Candidate> left;
  for (Candidate& each : candidates_) {
    Effects effects = effects_of(*each.base);
    std::ranges::copy(each.effects, std::back_inserter(effects));
    const std::vector<std::string_view> ids = ids_of_effects(effects);
    const TableEntry* target = table_.best_of(ids);
    if (target != nullptr && std::ranges::find(taken, ids) == taken.end()) continue;
    const bool is_worth_it = each.is_certain || promise(each) >= worth;
    if (!is_worth_it || (!each.is_certain && taken.size() >= search_effort.combinations && !is_in(taken, ids))) {
      left.push_back(std::move(each));
      continue;
    }
    if (!is_in(taken, ids)) taken.push_back(ids);
    add(out, {.plan = with_added_effects(*each.from, each.effects),
              .kind = StartKind::larger,
              .target = target,
              .reference = each.base});
  }
  candidates_ = std::move(left);
}

// What an effect gains by its predicted strength, whose density a priori counts against it (the further numbers of an
// effect are as free as they were). `direction`: length of the change of residuals by its guess.
double SearchStarts::evidence_of(const Effect& effect, double direction, double share) const {
  const PriorOfNumbers prior = prior_of_numbers(effect, table_.with().scale);
  double out = prior.log_density;
  for (const double precision : prior.precisions) out += 0.5 * std::log(2.0 * std::numbers::pi / precision);
  const double octaves_known = 1.0 / (direction * std::max(std::abs(share), search_effort.weakest_start));
  return out + std::min(0.0, std::log(octaves_known / std::numbers::ln10));
}

// `every_kind`: what the numbers of a base have taken up of an effect the screening does not see.
void SearchStarts::screen_beside(const TableEntry& base, bool every_kind) {
  if (base.fitted.hypothesis.effects().size() >= search_effort.largest_hypothesis) return;
  if (base.fitted.hypothesis.effects().empty() || is_in(extended_, base.ids())) return;
  extended_.push_back(base.ids());
  const double least_fall = table_.leaves_noise() ? 0.0 : decision_thresholds.least_share * base.fitted.fit.objective();
  const std::vector<ScreenedEffect> screened =
      screen_effects(table_.with().runs, base.fitted, {.kinds = with_.tested, .scale = table_.with().scale});
  for (const EffectKind* kind : with_.tested) {
    if (are_among({kind}, base.fitted.kinds())) continue;
    double evidence = -std::numeric_limits<double>::infinity();
    for (const ScreenedEffect& each : screened)
      if (each.guess.kind == kind && each.predicted_chi_square_fall > least_fall)
        evidence =
            std::max(evidence, 0.5 * each.predicted_chi_square_fall +
                                   evidence_of(each.effect, each.residual_direction.norm(), each.predicted_share));
    for (const Effect& start : starts_for_short_fit(kind, screened))
      candidates_.push_back(
          {.base = &base, .from = &base.fitted, .effects = {start}, .evidence = evidence, .is_certain = every_kind});
  }
}

void SearchStarts::screen_together() {
  if (together_ >= search_effort.largest_hypothesis) return;
  ++together_;
  add_combinations(without_->fitted, with_.screened);
  if (together_ > 2 || table_.leaves_noise()) return;
  for (FittedHypothesis& each : less_damped()) {
    variants_.push_back(std::move(each));
    add_combinations(variants_.back(), screen_effects(table_.with().runs, variants_.back(),
                                                      {.kinds = with_.tested, .scale = table_.with().scale}));
  }
}

// Of what was screened beside `from`.
void SearchStarts::add_combinations(const FittedHypothesis& from, std::span<const ScreenedEffect> screened) {
  // The strength that is predicted falls short of an effect that is far from linear: some are fitted in any case.
  constexpr std::size_t certain = 2;
  const double rise = from.fit.objective() - without_->fitted.fit.objective();
  std::size_t place = 0;
  for (const ScreenedCombination& each :
       combinations_by_predicted_fall(from, screened, together_, search_effort.combinations)) {
    double evidence = 0.5 * (each.predicted_chi_square_fall - rise);
    for (const Effect& effect : each.effects) evidence += evidence_of(effect, 1.0, 1.0);
    candidates_.push_back({.base = without_,
                           .from = &from,
                           .effects = each.effects,
                           .evidence = evidence,
                           .is_certain = !table_.leaves_noise() && place++ < certain});
  }
}

// The model without effects where half of its free damping, and all of it, is left to effects: they imitate it, and
// from where it is fitted without them no direction leads to several of them together.
std::vector<FittedHypothesis> SearchStarts::less_damped() const {
  const FittedHypothesis& fitted = without_->fitted;
  const auto& numbers = fitted.hypothesis.declared().calibration;
  std::vector<FittedHypothesis> out;
  for (const double share : {0.5, 0.0}) {
    PlannedFit plan{.hypothesis = fitted.hypothesis, .start = fitted.fit.values, .local_numbers_from = &fitted.fit};
    bool any = false;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const fit::FitParameter& number = fitted.hypothesis.parameters()[i];
      if (number.has_prior() || number.key.find("damping") == std::string::npos) continue;
      auto& value = plan.start[static_cast<Eigen::Index>(i)];
      value = std::max(number.lower, share * value);
      any = true;
    }
    if (!any) break;
    fit::FitRequest request = fit_request_of(table_.with().runs, plan);
    request.effort = {.iterations = 0};
    if (auto there = fit::evaluate_with_jacobian(request))
      out.push_back(score(table_.with().runs, fitted.hypothesis, std::move(*there)));
  }
  return out;
}

}  // namespace coilwright::measurement::identification
