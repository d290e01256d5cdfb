#include "measurement/identification/level_fits.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <mutex>
#include <optional>
#include <utility>

#include "measurement/fit/parallel.hpp"
#include "measurement/identification/effect_strength.hpp"
#include "measurement/identification/model_error.hpp"
#include "measurement/identification/other_optima.hpp"
#include "measurement/identification/reached_limits.hpp"
#include "measurement/identification/search_effort.hpp"
#include "measurement/identification/staged_fit.hpp"
#include "measurement/replay/if_possible.hpp"

namespace coilwright::measurement::identification {
namespace {

using actuator::Effect;
using MaybeFit = std::optional<FittedHypothesis>;

template <class Value>
const Value* pointer_to(const std::optional<Value>& value) {
  return value ? &*value : nullptr;
}

// Turn by turn, and after each of them the worse half of those that go on is left where it is.
void race(std::vector<FitInTurns>& fits) {
  std::vector<FitInTurns*> going;
  for (FitInTurns& each : fits) going.push_back(&each);
  while (!going.empty()) {
    std::vector<char> goes_on(going.size());
    fit::in_parallel(going.size(), [&](std::size_t k) { goes_on[k] = going[k]->turn() ? 1 : 0; });
    std::vector<FitInTurns*> left;
    for (std::size_t k = 0; k < going.size(); ++k)
      if (goes_on[k] != 0) left.push_back(going[k]);
    std::ranges::stable_sort(left, {}, [](const FitInTurns* each) { return each->reached()->objective(); });
    left.resize((left.size() + 1) / 2);
    going = std::move(left);
  }
}

// The best of several fits that start for `known`, continued to convergence; nothing if there is none.
MaybeFit best_fit(std::span<const replay::PreparedRun> runs, std::vector<PlannedFit> plans,
                  const FittedHypothesis& known) {
  std::vector<FitInTurns> fits;
  for (PlannedFit& plan : plans) fits.emplace_back(runs, std::move(plan), search_effort.converged);
  // Whatever start is the best there leads to an answer that is wrong: what is fitted only has to be near enough to its
  // optimum to be ranked, and to be extended by what it lacks.
  if (is_far_from_noise(known))
    race(fits);
  else
    fit::in_parallel(fits.size(), [&](std::size_t i) { fits[i].finish(); });
  FitInTurns* best = nullptr;
  for (FitInTurns& each : fits) {
    if (each.reached() == nullptr) continue;
    if (best == nullptr || each.reached()->objective() < best->reached()->objective()) best = &each;
  }
  return best != nullptr ? std::move(*best).result() : std::nullopt;
}

// The plans whose short fits end lowest, from where these end; all are for the hypothesis of `known`, or a larger one.
// Those that bring no derivatives take those of the declared numbers.
std::vector<PlannedFit> most_promising(std::span<const replay::PreparedRun> runs, const FittedHypothesis& known,
                                       std::vector<PlannedFit> plans, const fit::Fit* at_declared) {
  constexpr std::size_t most = 2;
  std::vector<PlannedFit> out;
  std::vector<std::optional<fit::Fit>> fits(plans.size());
  fit::in_parallel(plans.size(), [&](std::size_t i) {
    fit::FitRequest request = fit_request_of(runs, plans[i]);
    if (request.derivatives_from == nullptr) request.derivatives_from = at_declared;
    request.effort = ends_by_what_is_left(search_effort.short_fit, known);
    fits[i] = fit::fit(request);
  });
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < plans.size(); ++i) {
    if (fits[i]) order.emplace_back(fits[i]->objective(), i);
  }
  std::ranges::sort(order);
  for (std::size_t k = 0; k < std::min(most, order.size()); ++k) {
    PlannedFit& plan = plans[order[k].second];
    plan.start = fits[order[k].second]->values;
    out.push_back(std::move(plan));
  }
  return out;
}

// Of a level in its order: the first ones, and those that explain enough of what the size before has left.
std::vector<char> worth_more_runs(std::span<const double> objectives, double of_the_size_before) {
  constexpr std::size_t always = 2;
  const double most = objectives.empty() ? 0.0 : of_the_size_before - std::ranges::min(objectives);
  std::vector<char> out;
  for (const double objective : objectives) {
    const double explained = of_the_size_before - objective;
    out.push_back(out.size() < always || explained >= search_effort.worth_more_runs * most ? 1 : 0);
  }
  return out;
}

// The discrete choices of all effects of a start.
std::vector<double> choices_of_all(const std::vector<Effect>& start) {
  std::vector<double> out;
  for (const Effect& effect : start) std::ranges::copy(choices_of(effect), std::back_inserter(out));
  return out;
}

// Those of several starts that make the discrete choices of this one.
std::vector<std::vector<Effect>> with_the_choices_of(const std::vector<Effect>& start,
                                                     const std::vector<std::vector<Effect>>& all) {
  std::vector<std::vector<Effect>> out;
  std::ranges::copy_if(all, std::back_inserter(out),
                       [&](const std::vector<Effect>& each) { return choices_of_all(each) == choices_of_all(start); });
  return out;
}

// Starts with the same discrete choices together, in the order in which their first ones come.
std::vector<std::vector<std::vector<Effect>>> by_choices(const std::vector<std::vector<Effect>>& starts) {
  std::vector<std::vector<double>> choices;
  std::vector<std::vector<std::vector<Effect>>> out;
  for (const std::vector<Effect>& start : starts) {
    std::vector<double> own = choices_of_all(start);
    const auto known = std::ranges::find(choices, own);
    if (known == choices.end()) {
      choices.push_back(std::move(own));
      out.push_back({start});
    } else {
      out[static_cast<std::size_t>(known - choices.begin())].push_back(start);
    }
  }
  return out;
}

// A hypothesis that could be fitted from none of its starts.
RuledOut ruled_out(const PlannedExtension& planned) {
  const PlannedFit plan = with_added_effects(*planned.base, planned.starts.front());
  const auto refusal = replay::refusal_of([&] { (void)plan.hypothesis.model_at(plan.start); });
  return {.effects = planned.kinds(),
          .remark = "leaves the model from every start that was tried: " +
                    refusal.value_or("its motion cannot be followed under all inputs of the records")};
}

// What the best of several short fits explains of what its base leaves, if it leaves noise where it converges (it is
// moved there): other starts then only matter to hypotheses that may explain as much. 0 if it does not.
double explained_by_an_answer(std::span<const replay::PreparedRun> runs, std::span<const PlannedExtension> planned,
                              std::span<const std::size_t> places, std::span<std::optional<ShortFit>> fits) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < fits.size(); ++i)
    if (fits[i] && (!best || fits[i]->fitted.objective() < fits[*best]->fitted.objective())) best = i;
  if (!best) return 0.0;
  const FittedHypothesis& base = *planned[places[*best]].base;
  const double explained = base.fit.objective() - fits[*best]->fitted.objective();
  constexpr double most = 0.5;  // less of what is above the noise does not leave noise
  if (explained < most * base.chi_square_above_noise()) return 0.0;
  MaybeFit converged = refine(runs, *fits[*best]);
  if (!converged || !converged->whiteness.is_white()) return 0.0;
  fits[*best]->plan.start = converged->fit.values;
  fits[*best]->fitted = std::move(converged->fit);
  return base.fit.objective() - fits[*best]->fitted.objective();
}

// A level whose hypotheses are moved to better optima one by one.
class OtherOptima {
 public:
  OtherOptima(std::span<const replay::PreparedRun> runs, HypothesesOfSize level, const actuator::RigScale& scale,
              std::uint64_t seed)
      : runs_(runs), scale_(scale), seed_(seed), level_(std::move(level)) {
    at_declared_ = at_declared_numbers(runs_, level_.front().hypothesis.declared());
  }

  [[nodiscard]] const HypothesesOfSize& level() const { return level_; }

  // With one of its discrete choices the other way.
  void try_other_choices(std::size_t i) {
    const FittedHypothesis as_found = level_[i];
    take_better(with_other_choices(as_found), level_[i]);
  }

  // From other starts.
  void restart(std::size_t i) {
    FittedHypothesis& best = level_[i];
    const FittedHypothesis as_found = best;
    take_better(with_other_starts(as_found, seed_), best);
    const FittedHypothesis restarted = best;
    take_better(from_reached_limits(runs_, restarted), best);
    if (is_far_from_noise(as_found)) return;
    take_better(most_promising(runs_, as_found, from_own_starts(as_found, scale_), declared_derivatives()), best);
  }

  // Adds the same with further numbers of its effects, and without them at the optimum to which these led. That may
  // have more evidence although it leaves more, as where nothing touches a face: the larger one must not be credited
  // with it.
  void extend(std::size_t i) {
    const FittedHypothesis smaller = level_[i];
    std::vector<PlannedFit> plans = with_further_numbers(smaller, scale_);
    // Far from the noise they race instead.
    if (!is_far_from_noise(smaller)) plans = most_promising(runs_, smaller, std::move(plans), declared_derivatives());
    MaybeFit larger = best_fit(runs_, std::move(plans), smaller);
    if (!larger) return;
    if (MaybeFit beside = best_fit(runs_, {from_further_numbers(smaller, *larger)}, smaller)) {
      if (beside->fit.objective() < smaller.fit.objective()) std::swap(*beside, level_[i]);
      level_.push_back(std::move(*beside));
    }
    level_.push_back(std::move(*larger));
  }

  [[nodiscard]] HypothesesOfSize result() && { return std::move(level_); }

 private:
  void take_better(std::vector<PlannedFit> plans, FittedHypothesis& best) {
    MaybeFit other = best_fit(runs_, std::move(plans), best);
    if (other && other->fit.objective() < best.fit.objective()) best = std::move(*other);
  }

  [[nodiscard]] const fit::Fit* declared_derivatives() const { return pointer_to(at_declared_); }

  std::span<const replay::PreparedRun> runs_;
  const actuator::RigScale& scale_;
  std::uint64_t seed_;
  HypothesesOfSize level_;
  std::optional<fit::Fit> at_declared_{};
};

}  // namespace

bool leaves_noise(const HypothesesOfSize& level) {
  return std::ranges::any_of(level, [](const FittedHypothesis& each) { return each.whiteness.is_white(); });
}

const FittedHypothesis* nearest(const HypothesesOfSize& level) {
  const auto best =
      std::ranges::min_element(level, {}, [](const FittedHypothesis& each) { return each.fit.objective(); });
  return best == level.end() ? nullptr : &*best;
}

LevelFits fit_level(std::span<const replay::PreparedRun> runs, const std::vector<PlannedExtension>& planned,
                    std::size_t refined, const std::function<void(std::size_t, const ShortFit*)>& progress) {
  std::vector<std::size_t> places;  // among `planned`, of each set of starts
  std::vector<std::vector<std::vector<Effect>>> starts;
  std::vector<std::vector<std::vector<Effect>>> further;
  std::vector<std::size_t> left(planned.size(), 0);
  for (std::size_t place = 0; place < planned.size(); ++place)
    for (std::vector<std::vector<Effect>>& alike : by_choices(planned[place].starts)) {
      places.push_back(place);
      further.push_back(with_the_choices_of(alike.front(), planned[place].further_starts));
      starts.push_back(std::move(alike));
      ++left[place];
    }
  if (starts.empty()) return {};
  // Of all fits that start there, which are many: taken once.
  const std::optional<fit::Fit> at_declared = at_declared_numbers(runs, planned.front().base->hypothesis.declared());
  std::vector<std::optional<ShortFit>> short_fits(starts.size());
  std::mutex reporting;
  std::size_t done = 0;
  fit::in_parallel(starts.size(), [&](std::size_t i) {
    short_fits[i] = short_fit(runs, *planned[places[i]].base, starts[i]);
    const std::scoped_lock lock(reporting);
    progress(done, pointer_to(short_fits[i]));
  });
  const double worth_other_starts =
      search_effort.worth_more_runs * explained_by_an_answer(runs, planned, places, short_fits);
  fit::in_parallel(starts.size(), [&](std::size_t i) {
    const PlannedExtension& plan = planned[places[i]];
    const bool is_worth_it = plan.predicted_fall >= worth_other_starts || is_worse_than(*plan.base, short_fits[i]);
    if (is_worth_it)
      short_fits[i] =
          from_other_starts(runs, *plan.base, starts[i], further[i], pointer_to(at_declared), std::move(short_fits[i]));
    const std::scoped_lock lock(reporting);
    if (--left[places[i]] == 0) ++done;
    progress(done, is_worth_it ? pointer_to(short_fits[i]) : nullptr);
  });
  struct Found {
    std::size_t place{};
    ShortFit fit;
  };
  LevelFits out;
  std::vector<Found> found;
  std::vector<char> failed(planned.size(), 1);
  for (std::size_t i = 0; i < short_fits.size(); ++i) {
    if (!short_fits[i]) continue;
    failed[places[i]] = 0;
    found.push_back({.place = places[i], .fit = std::move(*short_fits[i])});
  }
  for (std::size_t place = 0; place < planned.size(); ++place)
    if (failed[place] != 0) out.failed.push_back(ruled_out(planned[place]));
  std::ranges::stable_sort(found, {}, [](const Found& each) { return each.fit.fitted.objective(); });

  // A planned hypothesis stands where its best discrete choices do; what becomes of its other ones is known only once
  // they have converged as well.
  std::vector<std::size_t> order;
  std::vector<double> objectives;
  for (const Found& each : found) {
    if (std::ranges::find(order, each.place) != order.end()) continue;
    order.push_back(each.place);
    objectives.push_back(each.fit.fitted.objective());
  }
  double before = std::numeric_limits<double>::infinity();
  for (const PlannedExtension& each : planned) before = std::min(before, each.base->fit.objective());
  const std::vector<char> worth = worth_more_runs(objectives, before);
  std::vector<MaybeFit> fits(found.size());
  fit::in_parallel(found.size(), [&](std::size_t i) {
    ShortFit& from = found[i].fit;
    const auto rank = static_cast<std::size_t>(std::ranges::find(order, found[i].place) - order.begin());
    if (rank < refined && worth[rank] != 0)
      fits[i] = refine(runs, from);
    else
      fits[i] = score(runs, std::move(from.plan.hypothesis), std::move(from.fitted));
  });
  for (const std::size_t place : order) {
    std::optional<FittedHypothesis> best;
    for (std::size_t i = 0; i < found.size(); ++i) {
      if (found[i].place != place || !fits[i]) continue;
      if (!best || fits[i]->fit.objective() < best->fit.objective()) best = std::move(*fits[i]);
    }
    if (best) out.level.push_back(std::move(*best));
  }
  return out;
}

std::vector<std::size_t> contenders(const HypothesesOfSize& level, double of_the_size_before, std::size_t most) {
  std::vector<double> objectives;
  for (const FittedHypothesis& each : level) objectives.push_back(each.fit.objective());
  const std::vector<char> worth = worth_more_runs(objectives, of_the_size_before);
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < level.size() && i < most; ++i)
    if (worth[i] != 0) out.push_back(i);
  return out;
}

HypothesesOfSize with_better_optima(std::span<const replay::PreparedRun> runs, HypothesesOfSize level,
                                    double of_the_size_before, const actuator::RigScale& scale, std::uint64_t seed,
                                    const std::function<void(std::size_t, std::size_t)>& progress) {
  if (level.empty()) return {};
  OtherOptima optima(runs, std::move(level), scale, seed);
  const std::vector<std::size_t> tried = contenders(optima.level(), of_the_size_before, search_effort.reconsidered);
  for (const std::size_t i : tried) {
    const bool is_restarted = i < search_effort.restarted;
    if (leaves_noise(optima.level())) {
      // What leaves noise is the answer only as long as no near rival is better at an optimum that it has not reached.
      const double behind = optima.level()[i].fit.objective() - nearest(optima.level())->fit.objective();
      const bool is_near_rival = i > 0 && is_restarted && behind <= search_effort.near_rival;
      if (i > 0 && !is_near_rival) continue;
      progress(i + 1, tried.size());
      if (is_near_rival) optima.restart(i);
      // Where data tell its further numbers, intervals without them are wrong.
      if (i == 0) optima.extend(i);
      continue;
    }
    progress(i + 1, tried.size());
    optima.try_other_choices(i);
    if (is_restarted) optima.restart(i);
    if (!optima.level()[i].whiteness.is_white()) optima.extend(i);
  }
  return std::move(optima).result();
}

}  // namespace coilwright::measurement::identification
