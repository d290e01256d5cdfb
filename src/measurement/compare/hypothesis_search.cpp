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
#include "measurement/compare/linear_screening.hpp"
#include "measurement/compare/rig_scale.hpp"
#include "measurement/compare/search_effort.hpp"
#include "measurement/compare/select_hypothesis.hpp"

namespace coilwright::measurement::compare {
namespace {

using actuator::Effect;
using actuator::EffectKind;
using actuator::Model;
using fit::Counted;

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
  auto fitted = fit_to_convergence(runs, plan);
  if (!fitted.value)
    throw std::runtime_error("the declared model cannot be simulated under " + inputs_that_fail(runs, plan));
  return {.value = std::move(*fitted.value), .simulated_runs = fitted.simulated_runs};
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
  explicit HypothesisSearch(const AttributionRequest& request) : request_(request), runs_(request.runs) {}

  Attribution run() {
    const FittedHypothesis before = counted(recalibrated(runs_, *request_.declared));
    const Model nominal = before.hypothesis.model_at(before.fit.values);
    scale_ = rig_scale(runs_, nominal);
    ApplicableKinds applicable = applicable_kinds(request_.effects, nominal);
    kinds_ = std::move(applicable.kinds);
    report(fmt::format("recalibrated: rms residual {:.3g} times the noise", before.whiteness.level));

    const Screened screened = counted(screen(before));
    std::vector<FittedHypothesis> all = compare_levels(before, screened);
    Selection selection = select_hypothesis(runs_, before, std::move(all), overdispersion_);
    Attribution out{.steps = {before}, .overdispersion = overdispersion_};
    std::ranges::move(selection.steps, std::back_inserter(out.steps));
    out.rivals = std::move(selection.rivals);
    out.indistinguishable = std::move(selection.indistinguishable);
    for (auto* part : {&selection.ranked, &applicable.inapplicable, &selection.ruled_out})
      std::ranges::move(*part, std::back_inserter(out.compared));
    out.simulated_runs = simulated_runs_ + selection.simulated_runs;
    return out;
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
      level = counted(with_better_choices(std::move(level)));
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
      all.insert(all.end(), level.begin(), level.end());
      if (adequate || before.whiteness.is_white() || size == search_effort.largest_hypothesis) break;
      const double left = level.empty() ? above_noise : level.front().chi_square_above_noise();
      if (size > 1 && left > search_effort.worth_another_effect * above_noise) break;
      above_noise = left;
      Level next = counted(larger_hypotheses(level, size == 1 ? &before : nullptr, screened));
      if (next.empty()) break;
      level = std::move(next);
    }
    return all;
  }

  [[nodiscard]] Counted<Screened> screen(const FittedHypothesis& base) const {
    return screen_effects(runs_, base, {.kinds = kinds_, .scale = scale_, .seed = request_.seed});
  }

  // Every effect alone: a short fit of each, of which the best are continued to convergence.
  [[nodiscard]] Counted<Level> single_effects(const FittedHypothesis& base, const Screened& screened) const {
    std::vector<Counted<std::optional<ShortFit>>> short_fits(kinds_.size());
    std::mutex reporting;
    std::size_t done = 0;
    tbb::parallel_for(std::size_t{0}, kinds_.size(), [&](std::size_t i) {
      short_fits[i] = short_fit(runs_, base, starts_for_short_fit(kinds_[i], screened));
      const std::scoped_lock lock(reporting);
      if (++done % 8 == 0) report(fmt::format("{} of {} effects compared", done, kinds_.size()));
    });
    std::vector<ShortFit> found;
    long simulated_runs = 0;
    for (Counted<std::optional<ShortFit>>& each : short_fits) {
      simulated_runs += each.simulated_runs;
      if (each.value) found.push_back(std::move(*each.value));
    }
    std::ranges::stable_sort(found, {}, [](const ShortFit& each) { return each.fitted.objective(); });
    std::vector<CountedFit> fits(found.size());
    tbb::parallel_for(std::size_t{0}, found.size(), [&](std::size_t i) {
      if (i < search_effort.refined_singles)
        fits[i] = refine(runs_, found[i]);
      else
        fits[i].value = score(runs_, std::move(found[i].plan.hypothesis), std::move(found[i].fitted));
    });
    Counted<Level> out = succeeded(std::move(fits));
    out.simulated_runs += simulated_runs;
    return out;
  }

  // A level (sorted, best first) whose best hypotheses have other discrete choices where those are better.
  [[nodiscard]] Counted<Level> with_better_choices(Level level) const {
    const std::size_t count = std::min(search_effort.reconsidered, level.size());
    std::vector<long> simulated_runs(count, 0);
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
      if (level[i].whiteness.is_white()) return;
      const FittedHypothesis as_found = level[i];
      for (const PlannedFit& plan : with_other_choices(as_found)) {
        auto other = fit_to_convergence(runs_, plan);
        simulated_runs[i] += other.simulated_runs;
        if (other.value && other.value->fit.objective() < level[i].fit.objective()) level[i] = std::move(*other.value);
      }
    });
    Counted<Level> out{.value = std::move(level)};
    for (const long each : simulated_runs) out.simulated_runs += each;
    return out;
  }

  // Hypotheses with one effect more than those of `level` (sorted, best first); with `base`, also pairs added to it.
  [[nodiscard]] Counted<Level> larger_hypotheses(const Level& level, const FittedHypothesis* base,
                                                 const Screened& screened) const {
    std::vector<PlannedExtension> planned;
    long simulated_runs = 0;
    for (std::size_t i = 0; i < std::min(search_effort.beam, level.size()); ++i) {
      const Counted<Screened> more = screen(level[i]);
      simulated_runs += more.simulated_runs;
      for (const EffectKind* kind : kinds_by_predicted_fall(more.value, search_effort.extensions))
        planned.push_back({.base = &level[i], .effects = starts_for_short_fit(kind, more.value)});
    }
    if (base != nullptr) {
      for (auto& [first, second] : pairs_by_predicted_fall(*base, screened, search_effort.extensions))
        planned.push_back({.base = base, .effects = {std::move(first), std::move(second)}, .joint = true});
    }
    planned = without_repetitions(std::move(planned));
    std::vector<CountedFit> fits(planned.size());
    tbb::parallel_for(std::size_t{0}, planned.size(),
                      [&](std::size_t i) { fits[i] = fit_extension(runs_, planned[i]); });
    Counted<Level> out = succeeded(std::move(fits));
    out.simulated_runs += simulated_runs;
    return out;
  }

  const AttributionRequest& request_;
  std::span<const replay::PreparedRun> runs_;
  actuator::RigScale scale_;
  std::vector<const EffectKind*> kinds_;
  double overdispersion_ = 1.0;
  long simulated_runs_ = 0;
};

}  // namespace

Attribution attribute(const AttributionRequest& request) {
  return HypothesisSearch(request).run();
}

}  // namespace coilwright::measurement::compare
