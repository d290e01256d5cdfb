#include "measurement/identification/started_fits.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

#include "coilwright/measurement/identification/decision_thresholds.hpp"
#include "measurement/fit/parallel.hpp"
#include "measurement/identification/model_error.hpp"
#include "measurement/identification/search_effort.hpp"
#include "measurement/identification/staged_fit.hpp"

namespace coilwright::measurement::identification {
namespace {

struct StartedFit {
  Start start;
  double objective = std::numeric_limits<double>::infinity();
  std::optional<fit::Fit> fitted{};

  [[nodiscard]] std::vector<std::string_view> ids() const {
    std::vector<const actuator::EffectKind*> kinds;
    for (const actuator::Effect& each : start.plan.hypothesis.effects()) kinds.push_back(each.kind);
    return ids_of(kinds);
  }
};

// Whether the objective there is as the derivatives of the target's own fit predict it.
bool leads_back(const StartedFit& started) {
  constexpr double nearly = 0.5;
  if (!is_elsewhere_in(started.start)) return false;
  const FittedHypothesis& target = started.start.target->fitted;
  const double rise = predicted_rise(target, started.start.plan.start);
  return std::abs(started.objective - target.fit.objective() - rise) < nearly * rise;
}

// Of each hypothesis and kind of start.
std::vector<StartedFit> lowest_of_each(std::vector<StartedFit> all) {
  std::ranges::stable_sort(all, {}, &StartedFit::objective);
  std::vector<StartedFit> out;
  for (StartedFit& each : all) {
    const auto before = std::ranges::count_if(
        out, [&](const StartedFit& one) { return one.start.kind == each.start.kind && one.ids() == each.ids(); });
    const std::size_t most =
        each.start.kind == StartKind::other_optimum ? search_effort.own_starts : search_effort.settling_starts;
    if (static_cast<std::size_t>(before) < most) out.push_back(std::move(each));
  }
  return out;
}

// Whether a short fit is worth its place beside the best one of its hypothesis.
bool leads_elsewhere(const StartedFit& started) {
  const TableEntry* target = started.start.target;
  if (target == nullptr) return true;
  const double objective = target->fitted.fit.objective();
  if (started.objective > objective + decision_thresholds.decisive_gain) return false;
  if (started.objective < objective - target->negligible_fall()) return true;
  return !is_elsewhere_in(started.start) || predicted_rise(target->fitted, started.fitted->values) >= 1.0;
}

}  // namespace

bool continue_promising(HypothesisTable& table) {
  const double worth = table.worth_a_fit();
  std::vector<TableEntry*> heaviest;
  for (TableEntry& each : table.entries()) {
    if (table.promise(each) < worth) continue;
    const TableEntry& best = *table.best_of(each.ids());
    if (&best == &each || (!each.has_ended && each.fitted.fit.objective() - each.promised <
                                                  best.fitted.fit.objective() - best.negligible_fall()))
      heaviest.push_back(&each);
  }
  std::ranges::stable_sort(heaviest, std::ranges::greater{},
                           [&](const TableEntry* each) { return table.promise(*each); });
  heaviest.resize(std::min(heaviest.size(), search_effort.heaviest));
  std::vector<TableEntry*> going;
  std::ranges::copy_if(heaviest, std::back_inserter(going),
                       [](const TableEntry* each) { return !each->has_ended && !each->is_at_optimum(); });
  std::vector<std::optional<FittedHypothesis>> found(going.size());
  fit::in_parallel(going.size(), [&](std::size_t i) {
    const FittedHypothesis& from = going[i]->fitted;
    fit::FitEffort effort = search_effort.exact;
    effort.tolerance = std::max(effort.tolerance, going[i]->negligible_fall() / from.fit.objective());
    found[i] = fit_to_its_end(table.with().runs,
                              {.hypothesis = from.hypothesis,
                               .start = from.fit.values,
                               .local_numbers_from = &from.fit,
                               .derivatives_from = &from.fit},
                              effort);
  });
  std::vector<FittedHypothesis> ended, further;
  for (std::size_t i = 0; i < going.size(); ++i) {
    going[i]->has_ended = true;
    if (!found[i]) continue;
    const double fall = going[i]->fitted.fit.objective() - found[i]->fit.objective();
    (fall > decision_thresholds.decisive_gain ? further : ended).push_back(std::move(*found[i]));
  }
  table.add(std::move(ended), true);
  table.add(std::move(further), false);
  return !going.empty();
}

bool fit_from(std::vector<Start> starts, HypothesisTable& table) {
  std::vector<StartedFit> all;
  for (Start& each : starts) all.push_back({.start = std::move(each)});
  const auto runs = table.with().runs;
  const auto short_request = [&](const Start& start) {
    fit::FitRequest out = fit_request_of(runs, start.plan);
    const TableEntry& known = start.target != nullptr ? *start.target : *start.reference;
    out.effort = ends_by_what_is_left(search_effort.short_fit, known.fitted);
    return out;
  };
  fit::in_parallel(all.size(), [&](std::size_t i) {
    if (const auto there = fit::evaluate_at(short_request(all[i].start))) all[i].objective = there->objective();
  });
  std::erase_if(all, [](const StartedFit& each) { return std::isinf(each.objective) || leads_back(each); });
  all = lowest_of_each(std::move(all));
  fit::in_parallel(all.size(), [&](std::size_t i) {
    all[i].fitted = fit::fit(short_request(all[i].start));
    if (all[i].fitted) all[i].objective = all[i].fitted->objective();
  });
  std::vector<FittedHypothesis> found;
  for (StartedFit& each : all)
    if (each.fitted && leads_elsewhere(each))
      found.push_back(score(runs, std::move(each.start.plan.hypothesis), std::move(*each.fitted)));
  const bool any = !found.empty();
  table.add(std::move(found), false);
  return any;
}

}  // namespace coilwright::measurement::identification
