#include "measurement/compare/level_fits.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
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
  std::vector<CountedFit> fits(found.size());
  tbb::parallel_for(std::size_t{0}, found.size(), [&](std::size_t i) {
    if (i < refined)
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

Counted<Level> with_better_optima(std::span<const replay::PreparedRun> runs, Level level,
                                  const actuator::RigScale& scale, std::uint64_t seed) {
  Counted<Level> out{.value = std::move(level)};
  const std::size_t count = std::min(search_effort.reconsidered, out.value.size());
  const auto take_better = [&](const std::vector<PlannedFit>& plans, FittedHypothesis& best) {
    const CountedFit other = best_fit(runs, plans);
    out.simulated_runs += other.simulated_runs;
    if (other.value && other.value->fit.objective() < best.fit.objective()) best = *other.value;
  };
  for (std::size_t i = 0; i < count; ++i) {
    if (leaves_noise(out.value)) break;
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
