#include "measurement/compare/level_fits.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>
#include <mutex>
#include <optional>
#include <utility>

#include "measurement/compare/other_optima.hpp"
#include "measurement/compare/search_effort.hpp"
#include "measurement/compare/staged_fit.hpp"

namespace coilwright::measurement::compare {
namespace {

using fit::Counted;
using CountedFit = Counted<std::optional<FittedHypothesis>>;

// The best of several fits, each continued to convergence; nothing if there is none.
CountedFit best_fit(std::span<const replay::PreparedRun> runs, const std::vector<PlannedFit>& plans) {
  std::vector<CountedFit> fits(plans.size());
  tbb::parallel_for(std::size_t{0}, plans.size(), [&](std::size_t i) { fits[i] = fit_to_convergence(runs, plans[i]); });
  CountedFit out;
  for (CountedFit& each : fits) {
    out.simulated_runs += each.simulated_runs;
    if (each.value && (!out.value || each.value->fit.objective() < out.value->fit.objective()))
      out.value = std::move(each.value);
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

}  // namespace

bool leaves_noise(const Level& level) {
  return std::ranges::any_of(level, [](const FittedHypothesis& each) { return each.whiteness.is_white(); });
}

Counted<LevelFits> fit_level(std::span<const replay::PreparedRun> runs, const std::vector<PlannedExtension>& planned,
                             std::size_t refined, const std::function<void(std::size_t)>& progress) {
  std::vector<Counted<std::optional<ShortFit>>> short_fits(planned.size());
  std::mutex reporting;
  std::size_t done = 0;
  tbb::parallel_for(std::size_t{0}, planned.size(), [&](std::size_t i) {
    short_fits[i] = short_fit(runs, *planned[i].base, planned[i].starts);
    const std::scoped_lock lock(reporting);
    progress(++done);
  });
  Counted<LevelFits> out;
  std::vector<ShortFit> found;
  for (std::size_t i = 0; i < planned.size(); ++i) {
    out.simulated_runs += short_fits[i].simulated_runs;
    if (short_fits[i].value)
      found.push_back(std::move(*short_fits[i].value));
    else if (planned[i].kinds().size() == 1)
      out.value.failed.push_back(planned[i].kinds().front());
  }
  std::ranges::stable_sort(found, {}, [](const ShortFit& each) { return each.fitted.objective(); });
  std::vector<double> objectives;
  for (const ShortFit& each : found) objectives.push_back(each.fitted.objective());
  double before = std::numeric_limits<double>::infinity();
  for (const PlannedExtension& each : planned) before = std::min(before, each.base->fit.objective());
  const std::vector<char> worth = worth_more_runs(objectives, before);
  std::vector<CountedFit> fits(found.size());
  tbb::parallel_for(std::size_t{0}, found.size(), [&](std::size_t i) {
    if (i < refined && worth[i] != 0)
      fits[i] = refine(runs, found[i]);
    else
      fits[i].value = score(runs, std::move(found[i].plan.hypothesis), std::move(found[i].fitted));
  });
  for (CountedFit& fitted : fits) {
    out.simulated_runs += fitted.simulated_runs;
    if (fitted.value) out.value.level.push_back(std::move(*fitted.value));
  }
  return out;
}

std::vector<std::size_t> contenders(const Level& level, double of_the_size_before, std::size_t most) {
  std::vector<double> objectives;
  for (const FittedHypothesis& each : level) objectives.push_back(each.fit.objective());
  const std::vector<char> worth = worth_more_runs(objectives, of_the_size_before);
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < level.size() && i < most; ++i)
    if (worth[i] != 0) out.push_back(i);
  return out;
}

Counted<Level> with_better_optima(std::span<const replay::PreparedRun> runs, Level level, double of_the_size_before,
                                  const actuator::RigScale& scale, std::uint64_t seed,
                                  const std::function<void(std::size_t, std::size_t)>& progress) {
  Counted<Level> out{.value = std::move(level)};
  const auto take_better = [&](const std::vector<PlannedFit>& plans, FittedHypothesis& best) {
    const CountedFit other = best_fit(runs, plans);
    out.simulated_runs += other.simulated_runs;
    if (other.value && other.value->fit.objective() < best.fit.objective()) best = *other.value;
  };
  const std::vector<std::size_t> tried = contenders(out.value, of_the_size_before, search_effort.reconsidered);
  for (const std::size_t i : tried) {
    if (leaves_noise(out.value)) break;
    progress(i + 1, tried.size());
    const FittedHypothesis as_found = out.value[i];
    take_better(with_other_choices(as_found), out.value[i]);
    if (i < search_effort.restarted) take_better(with_other_starts(as_found, seed), out.value[i]);
    if (out.value[i].whiteness.is_white()) break;
    const FittedHypothesis smaller = out.value[i];
    CountedFit larger = best_fit(runs, with_further_numbers(smaller, scale));
    out.simulated_runs += larger.simulated_runs;
    if (larger.value) out.value.push_back(std::move(*larger.value));
  }
  return out;
}

}  // namespace coilwright::measurement::compare
