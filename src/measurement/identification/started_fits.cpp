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
  bool has_ended = false;

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

std::size_t most_of(StartKind kind) {
  // An effect has few starts of its own, and how low one is says little of the optimum to which it leads.
  if (kind == StartKind::own) return std::numeric_limits<std::size_t>::max();
  return kind == StartKind::other_optimum ? search_effort.own_starts : search_effort.settling_starts;
}

// Of each hypothesis and kind of start.
std::vector<StartedFit> lowest_of_each(std::vector<StartedFit> all) {
  std::ranges::stable_sort(all, {}, &StartedFit::objective);
  std::vector<StartedFit> out;
  for (StartedFit& each : all) {
    const auto before = std::ranges::count_if(
        out, [&](const StartedFit& one) { return one.start.kind == each.start.kind && one.ids() == each.ids(); });
    if (static_cast<std::size_t>(before) < most_of(each.start.kind)) out.push_back(std::move(each));
  }
  return out;
}

// Short fits from the own starts of an effect stop on the way through valleys that are bent, above the optimum that is
// known: the lowest of each hypothesis are fitted to their end before they are compared with it.
void end_lowest_of_own(std::span<const replay::PreparedRun> runs, std::vector<StartedFit>& all) {
  std::ranges::stable_sort(all, {}, &StartedFit::objective);
  std::vector<StartedFit*> going;
  for (StartedFit& each : all) {
    const auto before = std::ranges::count_if(going, [&](const StartedFit* one) { return one->ids() == each.ids(); });
    if (each.start.kind != StartKind::own || !each.fitted ||
        static_cast<std::size_t>(before) == search_effort.settling_starts)
      continue;
    if (each.objective <= each.start.target->fitted.fit.objective() + search_effort.other_optima_gain)
      going.push_back(&each);
  }
  fit::in_parallel(going.size(), [&](std::size_t i) {
    StartedFit& each = *going[i];
    auto ended = fit_to_its_end(runs,
                                {.hypothesis = each.start.plan.hypothesis,
                                 .start = each.fitted->values,
                                 .local_numbers_from = &*each.fitted,
                                 .derivatives_from = &*each.fitted},
                                search_effort.exact);
    if (!ended) return;
    each.objective = ended->fit.objective();
    each.fitted = std::move(ended->fit);
    each.has_ended = true;
  });
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

bool continue_promising(HypothesisTable& table, const FitsBegin& begin) {
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
  begin(going.size());
  std::vector<std::optional<FittedHypothesis>> found(going.size());
  fit::in_parallel(going.size(), [&](std::size_t i) {
    const FittedHypothesis& from = going[i]->fitted;
    fit::FitEffort effort = search_effort.exact;
    // Near the noise a fit that has ended a tenth of chi-square above its optimum may lead a true one.
    if (is_far_from_noise(from)) effort.tolerance = going[i]->negligible_fall() / from.fit.objective();
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

bool fit_from(std::vector<Start> starts, HypothesisTable& table, const FitsBegin& begin) {
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
  begin(all.size());
  fit::in_parallel(all.size(), [&](std::size_t i) {
    all[i].fitted = fit::fit(short_request(all[i].start));
    if (all[i].fitted) all[i].objective = all[i].fitted->objective();
  });
  end_lowest_of_own(runs, all);
  std::vector<FittedHypothesis> found, ended;
  for (StartedFit& each : all)
    if (each.fitted && leads_elsewhere(each))
      (each.has_ended ? ended : found)
          .push_back(score(runs, std::move(each.start.plan.hypothesis), std::move(*each.fitted)));
  const bool any = !found.empty() || !ended.empty();
  table.add(std::move(ended), true);
  table.add(std::move(found), false);
  return any;
}

}  // namespace coilwright::measurement::identification
