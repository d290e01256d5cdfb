#include "measurement/compare/hypothesis_search.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <utility>

#include "measurement/compare/hypothesis_extension.hpp"
#include "measurement/compare/joint_screening.hpp"
#include "measurement/compare/linear_screening.hpp"
#include "measurement/compare/other_optima.hpp"
#include "measurement/compare/rig_scale.hpp"
#include "measurement/compare/search_effort.hpp"
#include "measurement/compare/select_hypothesis.hpp"
#include "measurement/fit/outliers.hpp"

namespace coilwright::measurement::compare {
namespace {

using actuator::Effect;
using actuator::EffectKind;
using actuator::Model;
using fit::Counted;

using CountedFit = Counted<std::optional<FittedHypothesis>>;
using Screened = std::vector<ScreenedEffect>;
using Level = std::vector<FittedHypothesis>;  // hypotheses with the same number of effects

// The fits that succeeded, in their order.
Counted<Level> succeeded(std::vector<CountedFit> fits) {
  Counted<Level> out;
  for (CountedFit& fitted : fits) {
    out.simulated_runs += fitted.simulated_runs;
    if (fitted.value) out.value.push_back(std::move(*fitted.value));
  }
  return out;
}

const FittedHypothesis& least_chi_square(const Level& level, const FittedHypothesis& fallback) {
  const auto best =
      std::ranges::min_element(level, {}, [](const FittedHypothesis& each) { return each.fit.objective(); });
  return best == level.end() ? fallback : *best;
}

std::string names(const FittedHypothesis& fitted) {
  std::string out;
  for (const EffectKind* kind : fitted.kinds()) {
    if (!out.empty()) out += " + ";
    out += kind->id();
  }
  return out;
}

// The inputs of the first run that the model cannot follow by itself.
std::string inputs_that_fail(std::span<const replay::PreparedRun> runs, const PlannedFit& plan) {
  for (std::size_t r = 0; r < runs.size(); ++r)
    if (!fit::evaluate_at(fit_request_of(runs.subspan(r, 1), plan)).value) return "the inputs of " + runs[r].run->name;
  return "these inputs";
}

Counted<FittedHypothesis> recalibrated(std::span<const replay::PreparedRun> runs,
                                       const replay::DeclaredModel& declared) {
  PlannedFit plan{.hypothesis = fit::Hypothesis(declared, {})};
  plan.start = plan.hypothesis.start();
  auto fitted = fit_exactly(runs, plan);
  if (!fitted.value)
    throw std::runtime_error("the declared model cannot be simulated under " + inputs_that_fail(runs, plan));
  Counted<FittedHypothesis> out{.value = std::move(*fitted.value), .simulated_runs = fitted.simulated_runs};
  const FittedHypothesis first = out.value;
  for (const PlannedFit& other : with_other_starts(first, 0)) {
    auto there = fit_exactly(runs, other);
    out.simulated_runs += there.simulated_runs;
    if (there.value && there.value->fit.objective() < out.value.fit.objective()) out.value = std::move(*there.value);
  }
  return out;
}

struct ApplicableKinds {
  std::vector<const EffectKind*> kinds{};
  std::vector<ComparedHypothesis> inapplicable{};
};

ApplicableKinds applicable_kinds(const actuator::EffectCatalogue& catalogue, const Model& nominal) {
  ApplicableKinds out;
  for (const EffectKind* kind : catalogue.kinds()) {
    const auto& declared = nominal.nominal_spec().effects;
    if (std::ranges::any_of(declared, [&](const Effect& effect) { return effect.kind == kind; })) {
      out.inapplicable.push_back({.effects = {kind}, .remark = "is in the declared model already"});
    } else if (const auto reason = kind->inapplicable(nominal.nominal_spec())) {
      out.inapplicable.push_back({.effects = {kind}, .remark = "does not fit this rig: " + *reason});
    } else {
      out.kinds.push_back(kind);
    }
  }
  return out;
}

class HypothesisSearch {
 public:
  // While `may_find_outliers`, the search ends where the best hypothesis of a size shows more of them.
  HypothesisSearch(const AttributionRequest& request, bool may_find_outliers)
      : request_(request), runs_(request.runs), may_find_outliers_(may_find_outliers) {}

  // Nothing if more outliers were set aside.
  Counted<std::optional<Attribution>> run() {
    const FittedHypothesis before = counted(recalibrated(runs_, *request_.declared));
    const Model nominal = before.hypothesis.model_at(before.fit.values);
    scale_ = rig_scale(runs_, nominal);
    ApplicableKinds applicable = applicable_kinds(request_.effects, nominal);
    kinds_ = std::move(applicable.kinds);
    report(fmt::format("recalibrated: rms residual {:.3g} times the noise", before.whiteness.level));

    const Screened screened = counted(screen(before));
    std::vector<FittedHypothesis> all = compare_levels(before, screened);
    if (found_outliers_) return {.value = std::nullopt, .simulated_runs = simulated_runs_};
    Selection selection = select_hypothesis(runs_, before, std::move(all), overdispersion_);
    Attribution out{.steps = {before}, .overdispersion = overdispersion_};
    std::ranges::move(selection.steps, std::back_inserter(out.steps));
    out.rivals = std::move(selection.rivals);
    out.indistinguishable = std::move(selection.indistinguishable);
    for (auto* part : {&selection.ranked, &applicable.inapplicable, &failed_, &selection.ruled_out})
      std::ranges::move(*part, std::back_inserter(out.compared));
    return {.value = std::move(out), .simulated_runs = simulated_runs_ + selection.simulated_runs};
  }

 private:
  // Takes the value of a result and adds its simulated runs to those of the search.
  template <typename Value>
  Value counted(Counted<Value> result) {
    simulated_runs_ += result.simulated_runs;
    return std::move(result.value);
  }

  void report(const std::string& line) const {
    if (request_.progress) request_.progress(line);
  }

  // All hypotheses of one effect, two, ..., until one leaves white noise or another effect is not worth its runs.
  std::vector<FittedHypothesis> compare_levels(const FittedHypothesis& before, const Screened& screened) {
    Level level = counted(single_effects(before, screened));
    std::vector<FittedHypothesis> all;
    overdispersion_ = overdispersion_of(runs_, least_chi_square(level, before));
    double above_noise = before.chi_square_above_noise();
    const auto bic = [&](const FittedHypothesis& each) { return quasi_bic(each, overdispersion_); };
    for (std::size_t size = 1;; ++size) {
      std::ranges::stable_sort(level, {}, bic);
      level = counted(with_better_optima(std::move(level)));
      std::ranges::stable_sort(level, {}, bic);
      if (!level.empty()) {
        const FittedHypothesis& best = level.front();
        overdispersion_ = std::min(overdispersion_, overdispersion_of(runs_, best));
        report(fmt::format("best with {} effect{}: {}: rms residual {:.3g} times the noise, whiteness ratio {:.2g}",
                           size, size == 1 ? "" : "s", names(best), best.whiteness.level,
                           best.whiteness.whiteness_ratio));
      }
      const bool adequate =
          std::ranges::any_of(level, [](const FittedHypothesis& each) { return each.whiteness.is_white(); });
      if (!adequate && may_find_outliers_ && !level.empty() &&
          fit::set_outliers_aside_if_much(request_.runs, level.front().fit)) {
        found_outliers_ = true;
        break;
      }
      all.insert(all.end(), level.begin(), level.end());
      // Where declared numbers alone leave noise, more effects than one would only share what these do.
      if (before.whiteness.is_white() || size == search_effort.largest_hypothesis) break;
      if (adequate && !another_is_decisive(before, level)) break;
      const double left = level.empty() ? above_noise : level.front().chi_square_above_noise();
      const bool worth_extending = size == 1 || left <= search_effort.worth_another_effect * above_noise;
      auto combined = combinations_by_predicted_fall(before, screened, size + 1, search_effort.combinations);
      // Where one effect more is not worth its runs, only effects that help together are.
      if (!worth_extending)
        std::erase_if(combined, [&](const ScreenedCombination& each) {
          return before.chi_square_above_noise() - each.predicted_chi_square_fall >
                 search_effort.worth_another_effect * left;
        });
      above_noise = left;
      Level next = counted(larger_hypotheses(before, worth_extending ? level : Level{}, combined));
      if (next.empty()) break;
      level = std::move(next);
    }
    return all;
  }

  [[nodiscard]] Counted<Screened> screen(const FittedHypothesis& base) const {
    return screen_effects(runs_, base, {.kinds = kinds_, .scale = scale_});
  }

  // Whether the best of a level (sorted) is decisively better than the model without effects, and one more effect would
  // be decisive again, and worth its name, by its screening. A residual may pass as white because few samples tell
  // little of the noise; what an effect takes away from it does not depend on that.
  [[nodiscard]] bool another_is_decisive(const FittedHypothesis& before, const Level& level) {
    if (level.empty()) return false;
    const FittedHypothesis& best = level.front();
    if (quasi_bic(before, overdispersion_) - quasi_bic(best, overdispersion_) < decision_thresholds.decisive_gain)
      return false;
    const double per_number = penalty_per_number(best, overdispersion_);
    const Screened more = counted(screen(best));
    return std::ranges::any_of(more, [&](const ScreenedEffect& each) {
      const auto numbers = static_cast<double>(std::max<std::size_t>(1, each.guess.values.size()));
      if (each.predicted_chi_square_fall < decision_thresholds.least_of_noise * best.fit.chi_square) return false;
      return each.predicted_chi_square_fall / overdispersion_ - numbers * per_number >=
             decision_thresholds.decisive_gain;
    });
  }

  // Every effect alone.
  [[nodiscard]] Counted<Level> single_effects(const FittedHypothesis& base, const Screened& screened) {
    std::vector<PlannedExtension> planned;
    for (const EffectKind* kind : kinds_) planned.push_back(one_more(base, starts_for_short_fit(kind, screened)));
    return best_of(planned, search_effort.refined_singles);
  }

  // Hypotheses with one effect more than those of `level` (sorted, best first), and `combined` effects added to `base`.
  [[nodiscard]] Counted<Level> larger_hypotheses(const FittedHypothesis& base, const Level& level,
                                                 const std::vector<ScreenedCombination>& combined) {
    std::vector<PlannedExtension> planned;
    long simulated_runs = 0;
    for (std::size_t i = 0; i < std::min(search_effort.beam, level.size()); ++i) {
      const Counted<Screened> more = screen(level[i]);
      simulated_runs += more.simulated_runs;
      for (const EffectKind* kind : kinds_by_predicted_fall(more.value, search_effort.extensions))
        planned.push_back(one_more(level[i], starts_for_short_fit(kind, more.value)));
    }
    for (const ScreenedCombination& each : combined) planned.push_back({.base = &base, .starts = {each.effects}});
    Counted<Level> out = best_of(without_repetitions(std::move(planned)), search_effort.refined_extensions);
    out.simulated_runs += simulated_runs;
    return out;
  }

  // A short fit of each; the best `refined` are continued to convergence.
  [[nodiscard]] Counted<Level> best_of(const std::vector<PlannedExtension>& planned, std::size_t refined) {
    std::vector<Counted<std::optional<ShortFit>>> short_fits(planned.size());
    std::mutex reporting;
    std::size_t done = 0;
    tbb::parallel_for(std::size_t{0}, planned.size(), [&](std::size_t i) {
      short_fits[i] = short_fit(runs_, *planned[i].base, planned[i].starts);
      const std::scoped_lock lock(reporting);
      if (++done % 8 == 0) report(fmt::format("{} of {} hypotheses compared", done, planned.size()));
    });
    std::vector<ShortFit> found;
    long simulated_runs = 0;
    for (std::size_t i = 0; i < planned.size(); ++i) {
      simulated_runs += short_fits[i].simulated_runs;
      if (short_fits[i].value)
        found.push_back(std::move(*short_fits[i].value));
      else if (planned[i].kinds().size() == 1)
        failed_.push_back(
            {.effects = planned[i].kinds(), .remark = "leaves the model from every start that was tried"});
    }
    std::ranges::stable_sort(found, {}, [](const ShortFit& each) { return each.fitted.objective(); });
    std::vector<CountedFit> fits(found.size());
    tbb::parallel_for(std::size_t{0}, found.size(), [&](std::size_t i) {
      if (i < refined)
        fits[i] = refine(runs_, found[i]);
      else
        fits[i].value = score(runs_, std::move(found[i].plan.hypothesis), std::move(found[i].fitted));
    });
    Counted<Level> out = succeeded(std::move(fits));
    out.simulated_runs += simulated_runs;
    return out;
  }

  // A level (sorted, best first) whose best hypotheses are where another start or another discrete choice leads if that
  // is better; and these with further numbers of their effects. One after the other: once a hypothesis leaves noise,
  // the ones behind it are not worth their runs.
  [[nodiscard]] Counted<Level> with_better_optima(Level level) const {
    Counted<Level> out{.value = std::move(level)};
    const std::size_t count = std::min(search_effort.reconsidered, out.value.size());
    const auto take_better = [&](const std::vector<PlannedFit>& plans, FittedHypothesis& best) {
      const CountedFit other = best_fit(plans);
      out.simulated_runs += other.simulated_runs;
      if (other.value && other.value->fit.objective() < best.fit.objective()) best = *other.value;
    };
    for (std::size_t i = 0; i < count; ++i) {
      if (std::ranges::any_of(out.value, [](const FittedHypothesis& each) { return each.whiteness.is_white(); })) break;
      const FittedHypothesis as_found = out.value[i];
      take_better(with_other_choices(as_found), out.value[i]);
      if (i < search_effort.restarted) take_better(with_other_starts(as_found, request_.seed), out.value[i]);
      if (out.value[i].whiteness.is_white()) break;
      const FittedHypothesis smaller = out.value[i];
      CountedFit larger = best_fit(with_further_numbers(smaller, scale_));
      out.simulated_runs += larger.simulated_runs;
      if (larger.value) out.value.push_back(std::move(*larger.value));
    }
    return out;
  }

  // The best of several fits, each continued to convergence; nothing if there is none.
  [[nodiscard]] CountedFit best_fit(const std::vector<PlannedFit>& plans) const {
    std::vector<CountedFit> fits(plans.size());
    tbb::parallel_for(std::size_t{0}, plans.size(),
                      [&](std::size_t i) { fits[i] = fit_to_convergence(runs_, plans[i]); });
    CountedFit out;
    for (CountedFit& each : fits) {
      out.simulated_runs += each.simulated_runs;
      if (each.value && (!out.value || each.value->fit.objective() < out.value->fit.objective()))
        out.value = std::move(each.value);
    }
    return out;
  }

  const AttributionRequest& request_;
  std::span<const replay::PreparedRun> runs_;
  actuator::RigScale scale_;
  std::vector<const EffectKind*> kinds_;
  std::vector<ComparedHypothesis> failed_;
  bool may_find_outliers_;
  bool found_outliers_ = false;
  double overdispersion_ = 1.0;
  long simulated_runs_ = 0;
};

}  // namespace

Attribution attribute(const AttributionRequest& request) {
  constexpr int most_restarts = 2;
  long simulated_runs = 0;
  for (int restarts = 0;; ++restarts) {
    Counted<std::optional<Attribution>> found = HypothesisSearch(request, restarts < most_restarts).run();
    simulated_runs += found.simulated_runs;
    if (found.value) {
      found.value->simulated_runs = simulated_runs;
      return std::move(*found.value);
    }
    if (request.progress) request.progress("more outliers are certain now: the comparison begins anew without them");
  }
}

}  // namespace coilwright::measurement::compare
