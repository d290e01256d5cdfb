#include "measurement/identification/first_fits.hpp"

#include <algorithm>
#include <iterator>
#include <mutex>
#include <optional>
#include <utility>

#include "measurement/fit/parallel.hpp"
#include "measurement/identification/effect_strength.hpp"
#include "measurement/identification/search_effort.hpp"
#include "measurement/identification/staged_fit.hpp"
#include "measurement/replay/if_possible.hpp"

namespace coilwright::measurement::identification {
namespace {

using actuator::Effect;
using Effects = std::vector<Effect>;

std::vector<double> choices_of_all(const Effects& start) {
  std::vector<double> out;
  for (const Effect& effect : start) std::ranges::copy(choices_of(effect), std::back_inserter(out));
  return out;
}

// Starts of a planned hypothesis that make the same discrete choices.
struct AlikeStarts {
  std::size_t place{};  // of the hypothesis among the planned ones
  std::vector<Effects> starts{};
  std::vector<Effects> further{};
};

std::vector<AlikeStarts> by_choices(const std::vector<PlannedExtension>& planned) {
  std::vector<AlikeStarts> out;
  for (std::size_t place = 0; place < planned.size(); ++place) {
    const std::size_t first = out.size();
    const auto alike = [&](const Effects& start) {
      return std::find_if(out.begin() + static_cast<std::ptrdiff_t>(first), out.end(), [&](const AlikeStarts& each) {
        return choices_of_all(each.starts.front()) == choices_of_all(start);
      });
    };
    for (const Effects& start : planned[place].starts)
      if (const auto known = alike(start); known != out.end())
        known->starts.push_back(start);
      else
        out.push_back({.place = place, .starts = {start}});
    for (const Effects& start : planned[place].further_starts)
      if (const auto known = alike(start); known != out.end()) known->further.push_back(start);
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

// What the best of several short fits explains of what its base leaves above the noise, if that is most of it: other
// starts then only matter to hypotheses that may explain as much. 0 if it is not.
double explained_by_an_answer(const std::vector<PlannedExtension>& planned, const std::vector<AlikeStarts>& alike,
                              const std::vector<std::optional<ShortFit>>& fits) {
  constexpr double most_of_it = 0.5;
  double out = 0.0;
  for (std::size_t i = 0; i < fits.size(); ++i) {
    if (!fits[i]) continue;
    const FittedHypothesis& base = *planned[alike[i].place].base;
    const double explained = base.fit.objective() - fits[i]->fitted.objective();
    if (explained >= most_of_it * base.chi_square_above_noise()) out = std::max(out, explained);
  }
  return out;
}

}  // namespace

FirstFits first_fits(std::span<const replay::PreparedRun> runs, const std::vector<PlannedExtension>& planned,
                     const std::function<void(std::size_t)>& progress) {
  const std::vector<AlikeStarts> alike = by_choices(planned);
  if (alike.empty()) return {};
  // Of all fits that start there, which are many: taken once.
  const std::optional<fit::Fit> at_declared = at_declared_numbers(runs, planned.front().base->hypothesis.declared());
  std::vector<std::optional<ShortFit>> fits(alike.size());
  fit::in_parallel(alike.size(),
                   [&](std::size_t i) { fits[i] = short_fit(runs, *planned[alike[i].place].base, alike[i].starts); });
  const double explained = explained_by_an_answer(planned, alike, fits);
  std::mutex reporting;
  std::size_t done = 0;
  fit::in_parallel(alike.size(), [&](std::size_t i) {
    const PlannedExtension& plan = planned[alike[i].place];
    if (plan.predicted_fall >= search_effort.worth_more_runs * explained || is_worse_than(*plan.base, fits[i]))
      fits[i] = from_other_starts(runs, *plan.base, alike[i].starts, alike[i].further,
                                  at_declared ? &*at_declared : nullptr, std::move(fits[i]));
    const std::scoped_lock lock(reporting);
    progress(++done * planned.size() / alike.size());
  });
  FirstFits out;
  std::vector<char> failed(planned.size(), 1);
  for (std::size_t i = 0; i < fits.size(); ++i) {
    if (!fits[i]) continue;
    failed[alike[i].place] = 0;
    out.fits.push_back(score(runs, std::move(fits[i]->plan.hypothesis), std::move(fits[i]->fitted)));
  }
  for (std::size_t place = 0; place < planned.size(); ++place)
    if (failed[place] != 0) out.failed.push_back(ruled_out(planned[place]));
  return out;
}

}  // namespace coilwright::measurement::identification
