#include "measurement/compare/hypothesis_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "coilwright/measurement/compare/decision_thresholds.hpp"
#include "measurement/compare/hypothesis_extension.hpp"
#include "measurement/compare/joint_screening.hpp"
#include "measurement/compare/level_fits.hpp"
#include "measurement/compare/linear_screening.hpp"
#include "measurement/compare/model_error.hpp"
#include "measurement/compare/other_optima.hpp"
#include "measurement/compare/posterior.hpp"
#include "measurement/compare/recalibration.hpp"
#include "measurement/compare/rig_scale.hpp"
#include "measurement/compare/search_effort.hpp"
#include "measurement/compare/select_hypothesis.hpp"
#include "measurement/compare/settled_model_error.hpp"
#include "measurement/compare/staged_fit.hpp"
#include "measurement/compare/window_subsample.hpp"
#include "measurement/fit/outliers.hpp"

namespace coilwright::measurement::compare {
namespace {

using actuator::Effect;
using actuator::EffectKind;
using actuator::Model;

using Screened = std::vector<ScreenedEffect>;

const FittedHypothesis& nearest_or(const HypothesesOfSize& level, const FittedHypothesis& fallback) {
  const FittedHypothesis* best = nearest(level);
  return best == nullptr ? fallback : *best;
}

std::string names(const FittedHypothesis& fitted) {
  std::string out;
  for (const EffectKind* kind : fitted.kinds()) {
    if (!out.empty()) out += " + ";
    out += kind->id();
  }
  return out;
}

std::string effects_text(std::size_t count) {
  return fmt::format("{} effect{}", count, count == 1 ? "" : "s");
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
  // While `may_find_outliers`, the search ends where the best hypothesis of a size shows more of them. While
  // `may_weigh_priors`, the runs get the model error of the recalibrated model if that is far from the noise, and long
  // records are searched in part.
  HypothesisSearch(const AttributionRequest& request, bool may_find_outliers, bool may_weigh_priors)
      : request_(request),
        runs_(request.runs),
        may_find_outliers_(may_find_outliers),
        may_weigh_priors_(may_weigh_priors) {}

  // Nothing if more outliers were set aside.
  std::optional<Attribution> run() {
    const FittedHypothesis before = may_weigh_priors_ ? recalibrated_at_its_error(request_.runs, *request_.declared)
                                                      : recalibrated(request_.runs, *request_.declared);
    const Model nominal = before.hypothesis.model_at(before.fit.values);
    scale_ = rig_scale(runs_, nominal);
    ApplicableKinds applicable = applicable_kinds(request_.effects, nominal);
    kinds_ = std::move(applicable.kinds);
    recalibrated_ = &before;
    if (request_.known) request_.known(before, so_far_);
    report(fmt::format("recalibrated: rms residual {:.3g} times the noise", before.whiteness.level));
    const std::optional<FittedHypothesis> on_some = on_subsample_if_far(before);
    compared_with_ = on_some ? &*on_some : &before;

    std::vector<FittedHypothesis> all = compare_levels(on_some ? *on_some : before);
    if (found_outliers_) return std::nullopt;
    std::vector<ComparedHypothesis> on_some_only;
    if (on_some) {
      const std::vector<FittedHypothesis> best = split_off_the_best(all, overdispersion_);
      const std::vector<FittedHypothesis> others = std::exchange(all, back_on_all_windows(best));
      on_some_only = subsample_->compared(*on_some, others, overdispersion_);
    }
    Posterior posterior = posterior_of(before, all, kinds_, scale_, overdispersion_);
    Selection selection = select_hypothesis(runs_, before, std::move(all), overdispersion_);
    Attribution out{.steps = {before}, .overdispersion = overdispersion_};
    std::ranges::move(selection.steps, std::back_inserter(out.steps));
    out.posterior = std::move(posterior);
    out.kinds = kinds_;
    out.scale = scale_;
    out.rivals = std::move(selection.rivals);
    out.indistinguishable = std::move(selection.indistinguishable);
    for (auto* part : {&selection.ranked, &on_some_only, &applicable.inapplicable, &failed_, &selection.ruled_out})
      std::ranges::move(*part, std::back_inserter(out.compared));
    return out;
  }

 private:
  void report(const std::string& line) const {
    if (request_.progress) request_.progress(line);
  }

  // All hypotheses of one effect, two, ..., until one leaves white noise or another effect is not worth its runs.
  std::vector<FittedHypothesis> compare_levels(const FittedHypothesis& before) {
    const Screened screened = screen(before);
    HypothesesOfSize level = single_effects(before, screened);
    std::vector<FittedHypothesis> all;
    overdispersion_ = overdispersion_of(runs_, nearest_or(level, before));
    double above_noise = before.chi_square_above_noise();
    double of_the_size_before = before.fit.objective();
    bool is_last = false;
    for (std::size_t size = 1;; ++size) {
      sort(level);
      // Asked before runs are spent on the best of this level, and again of what these find.
      if (shows_more_outliers(level)) break;
      if (is_last || is_worth_other_starts(before, level, of_the_size_before))
        level = at_better_optima(std::move(level), of_the_size_before, size);
      if (!level.empty()) {
        const FittedHypothesis& best = level.front();
        overdispersion_ = std::min(overdispersion_, overdispersion_of(runs_, best));
        report(fmt::format("best with {}: {}: rms residual {:.3g} times the noise, whiteness ratio {:.2g}",
                           effects_text(size), names(best), best.whiteness.level, best.whiteness.structure));
      }
      if (shows_more_outliers(level)) break;
      all.insert(all.end(), level.begin(), level.end());
      // Where declared numbers alone leave noise, more effects than one would only share what these do.
      if (before.whiteness.is_white() || size == search_effort.largest_hypothesis || is_last) break;
      const bool is_answered = leaves_noise(level);
      is_last = is_answered && !another_is_decisive(before, level);
      if (is_last && !leaves_noise_by_further_numbers_only(level)) break;
      if (is_answered) keep_what_more_may_improve(level, is_last);
      const double left = level.empty() ? above_noise : level.front().chi_square_above_noise();
      const bool worth_extending = size == 1 || left <= search_effort.worth_another_effect * above_noise;
      std::vector<ScreenedCombination> combined;
      if (!is_answered || is_last)
        combined = combinations_by_predicted_fall(before, screened, size + 1, search_effort.combinations);
      // Where one effect more is not worth its runs, only effects that help together are.
      if (!worth_extending)
        std::erase_if(combined, [&](const ScreenedCombination& each) {
          return before.chi_square_above_noise() - each.predicted_chi_square_fall >
                 search_effort.worth_another_effect * left;
        });
      above_noise = left;
      HypothesesOfSize next =
          larger_hypotheses(before, worth_extending ? level : HypothesesOfSize{}, of_the_size_before, combined);
      if (next.empty()) break;
      of_the_size_before = nearest_or(level, before).fit.objective();
      level = std::move(next);
    }
    return all;
  }

  void sort(HypothesesOfSize& level) const {
    std::ranges::stable_sort(level, {},
                             [this](const FittedHypothesis& each) { return quasi_bic(each, overdispersion_); });
  }

  // See with_better_optima; sorted again.
  [[nodiscard]] HypothesesOfSize at_better_optima(HypothesesOfSize level, double of_the_size_before, std::size_t size) {
    level = with_better_optima(
        runs_, std::move(level), of_the_size_before, scale_, request_.seed, [&](std::size_t place, std::size_t of) {
          report(fmt::format("other starts of the best with {}: {} of {}", effects_text(size), place, of));
        });
    sort(level);
    return level;
  }

  // Keeps hypotheses with white residuals, if any. These are the answer, alone or with one effect more: neither other
  // hypotheses of their size nor combinations without them are nearer to one. Where only further numbers leave noise
  // (`is_last`), two effects may do what these do: a friction and a drag, what a friction that falls with the speed
  // does. They compete, and end the search.
  void keep_what_more_may_improve(HypothesesOfSize& level, bool is_last) const {
    std::erase_if(level, [&](const FittedHypothesis& each) {
      return is_last ? has_further_numbers(each) : !each.whiteness.is_white();
    });
  }

  // Whether one of its effects has numbers beyond those of the catalogue (EffectKind::with_further_numbers).
  [[nodiscard]] bool has_further_numbers(const FittedHypothesis& fitted) const {
    return std::ranges::any_of(
        fitted.kinds(), [this](const EffectKind* kind) { return std::ranges::find(kinds_, kind) == kinds_.end(); });
  }

  // What leaves noise needs them for that.
  [[nodiscard]] bool leaves_noise_by_further_numbers_only(const HypothesesOfSize& level) const {
    return std::ranges::none_of(level, [this](const FittedHypothesis& each) {
      return each.whiteness.is_white() && !has_further_numbers(each);
    });
  }

  // Where the model without effects leaves noise and the best of a level (sorted) is not decisively better, other
  // optima of it would only fit the noise. Where it leaves much and no hypothesis of the level explains more than next
  // to nothing of that, effects were tried from starts of their own already.
  [[nodiscard]] bool is_worth_other_starts(const FittedHypothesis& before, const HypothesesOfSize& level,
                                           double of_the_size_before) const {
    if (level.empty()) return false;
    if (before.whiteness.is_white()) return is_decisive(before, level.front());
    const double explained = of_the_size_before - nearest(level)->fit.objective();
    return leaves_noise(level) || explained >= search_effort.next_to_nothing * before.chi_square_above_noise();
  }

  [[nodiscard]] bool is_decisive(const FittedHypothesis& before, const FittedHypothesis& best) const {
    return quasi_bic(before, overdispersion_) - quasi_bic(best, overdispersion_) >= decision_thresholds.decisive_gain;
  }

  // Whether the best of a level (sorted) shows samples that no motion can show, and enough of them to begin anew; they
  // are set aside then. Outliers hide others: what they pulled away is fitted again without them until it shows no
  // more, as a whole comparison for each such step would take minutes and find the same samples.
  [[nodiscard]] bool shows_more_outliers(const HypothesesOfSize& level) {
    constexpr int most_steps = 4;
    if (!may_find_outliers_ || level.empty() || leaves_noise(level)) return false;
    FittedHypothesis best = level.front();
    for (int step = 0; step < most_steps; ++step) {
      if (!fit::set_outliers_aside_if_much(runs_, best.fit)) break;
      found_outliers_ = true;
      auto anew = fit_exactly(
          runs_, {.hypothesis = best.hypothesis, .start = best.fit.values, .local_numbers_from = &best.fit});
      if (!anew) break;
      best = std::move(*anew);
    }
    if (subsample_) subsample_->hand_on_outliers();
    return found_outliers_;
  }

  // Where the recalibrated model is far from the noise on long records, the search goes on with some of their windows.
  // Returns the recalibrated model fitted to them; nothing where all windows stay.
  [[nodiscard]] std::optional<FittedHypothesis> on_subsample_if_far(const FittedHypothesis& before) {
    // Begun anew, because the answer leaves far less, it looks for what all samples show.
    if (!may_weigh_priors_ || before.whiteness.level < search_effort.weighs_model_error) return std::nullopt;
    std::unique_ptr<WindowSubsample> some = WindowSubsample::of(request_.runs);
    if (!some) return std::nullopt;
    std::optional<FittedHypothesis> there =
        fit_exactly(some->runs(), {.hypothesis = before.hypothesis, .start = before.fit.values});
    if (!there) return std::nullopt;
    subsample_ = std::move(some);
    runs_ = subsample_->runs();
    report(fmt::format("hypotheses are compared on {}, and judged on all", subsample_->text()));
    return there;
  }

  [[nodiscard]] std::vector<FittedHypothesis> back_on_all_windows(const std::vector<FittedHypothesis>& best) {
    runs_ = request_.runs;
    report(fmt::format("the best {} hypotheses are fitted to all windows", best.size()));
    std::vector<FittedHypothesis> all = subsample_->on_all(best);
    if (const FittedHypothesis* nearest_of_all = nearest(all))
      overdispersion_ = overdispersion_of(runs_, *nearest_of_all);
    return all;
  }

  [[nodiscard]] Screened screen(const FittedHypothesis& base) const {
    return screen_effects(runs_, base, {.kinds = kinds_, .scale = scale_});
  }

  // Whether the best of a level (sorted) is decisively better than the model without effects, and one more effect would
  // be decisive again, and worth its name, by its screening. A residual may pass as white because few samples tell
  // little of the noise; what an effect takes away from it does not depend on that.
  [[nodiscard]] bool another_is_decisive(const FittedHypothesis& before, const HypothesesOfSize& level) {
    if (level.empty()) return false;
    const FittedHypothesis& best = level.front();
    if (!is_decisive(before, best)) return false;
    const double per_number = penalty_per_number(best, overdispersion_);
    const Screened more = screen(best);
    return std::ranges::any_of(more, [&](const ScreenedEffect& each) {
      const auto numbers = static_cast<double>(std::max<std::size_t>(1, each.guess.values.size()));
      if (each.predicted_chi_square_fall < decision_thresholds.least_of_noise * best.fit.chi_square) return false;
      return each.predicted_chi_square_fall / overdispersion_ - numbers * per_number >=
             decision_thresholds.decisive_gain;
    });
  }

  // Every effect alone.
  [[nodiscard]] HypothesesOfSize single_effects(const FittedHypothesis& base, const Screened& screened) {
    std::vector<PlannedExtension> planned;
    for (const EffectKind* kind : kinds_) {
      planned.push_back(one_more(base, starts_for_short_fit(kind, screened)));
      // An effect of one number has one shape.
      if (kind->parameters().size() < 2) continue;
      for (Effect& start : own_starts(kind, screened)) planned.back().further_starts.push_back({std::move(start)});
    }
    return best_of(planned, search_effort.refined_singles);
  }

  // Hypotheses with one effect more than those of `level` (sorted, best first), and `combined` effects added to `base`.
  [[nodiscard]] HypothesesOfSize larger_hypotheses(const FittedHypothesis& base, const HypothesesOfSize& level,
                                                   double of_the_size_before,
                                                   const std::vector<ScreenedCombination>& combined) {
    std::vector<PlannedExtension> planned;
    for (const std::size_t i : contenders(level, of_the_size_before, search_effort.beam)) {
      const Screened more = screen(level[i]);
      for (const EffectKind* kind : kinds_by_predicted_fall(more, search_effort.extensions))
        planned.push_back(one_more(level[i], starts_for_short_fit(kind, more)));
    }
    for (const ScreenedCombination& each : combined) planned.push_back({.base = &base, .starts = {each.effects}});
    return best_of(without_repetitions(std::move(planned)), search_effort.refined_extensions);
  }

  // See fit_level.
  [[nodiscard]] HypothesesOfSize best_of(const std::vector<PlannedExtension>& planned, std::size_t refined) {
    std::size_t reported = 0;
    LevelFits fits = fit_level(runs_, planned, refined, [&](std::size_t done, const ShortFit* latest) {
      if (latest != nullptr && request_.known) make_known(*latest);
      if (done % 8 == 0 && done != reported) report(fmt::format("{} of {} hypotheses compared", done, planned.size()));
      reported = done;
    });
    for (const EffectKind* kind : fits.failed) {
      ComparedHypothesis& out = failed_.emplace_back();
      out.effects = {kind};
      out.remark = "leaves the model from every start that was tried";
    }
    return std::move(fits.level);
  }

  // Of starts with several discrete choices the best one stands for the hypothesis.
  void make_known(const ShortFit& fit) {
    const FittedHypothesis fitted = score(runs_, fit.plan.hypothesis, fit.fitted);
    ComparedHypothesis latest{.effects = fitted.kinds(),
                              .evidence = evidence_between(runs_, *compared_with_, fitted, overdispersion_)};
    const auto known = std::ranges::find(so_far_, latest.effects, &ComparedHypothesis::effects);
    constexpr double none = -std::numeric_limits<double>::infinity();
    const auto gain = [](const ComparedHypothesis& each) {
      return each.evidence ? each.evidence->criterion_gain : none;
    };
    if (known == so_far_.end())
      so_far_.push_back(std::move(latest));
    else if (gain(latest) > gain(*known))
      *known = std::move(latest);
    std::ranges::stable_sort(so_far_, std::greater{}, gain);
    request_.known(*recalibrated_, so_far_);
  }

  const AttributionRequest& request_;
  const FittedHypothesis* recalibrated_ = nullptr;
  const FittedHypothesis* compared_with_ = nullptr;  // the same on the windows of the search
  std::vector<ComparedHypothesis> so_far_;           // by short fits
  std::unique_ptr<WindowSubsample> subsample_;       // null where the search uses all
  std::span<replay::PreparedRun> runs_;              // with all windows, or some
  actuator::RigScale scale_;
  std::vector<const EffectKind*> kinds_;
  std::vector<ComparedHypothesis> failed_;
  bool may_find_outliers_;
  bool may_weigh_priors_;
  bool found_outliers_ = false;
  double overdispersion_ = 1.0;
};

}  // namespace

Attribution attribute(const AttributionRequest& request) {
  constexpr int most_restarts = 2;
  const auto say = [&](const char* line) {
    if (request.progress) request.progress(line);
  };
  int restarts = 0;
  bool may_weigh_priors = true;
  while (true) {
    std::optional<Attribution> found = HypothesisSearch(request, restarts < most_restarts, may_weigh_priors).run();
    if (!found) {
      say("more outliers are certain now: the comparison begins anew without them");
      ++restarts;
      continue;
    }
    const double searched = replay::model_error_of(request.runs);
    const double left = model_error_of(request.runs, found->after());
    if (may_weigh_priors && left < search_effort.much_less_model_error * searched) {
      say("far less is left over than without effects: the comparison begins anew, weighed by what is left");
      set_model_error(request.runs, left);
      may_weigh_priors = false;
      continue;
    }
    const std::size_t samples = found->after().fit.samples();
    Attribution out = with_settled_model_error(request.runs, std::move(*found));
    // What is reported of the answer is what it is now; its rivals in the table stay as they were compared.
    if (replay::model_error_of(request.runs) != searched || out.after().fit.samples() != samples ||
        replay::weighs_input_errors(request.runs))
      for (ComparedHypothesis& each : out.compared)
        if (std::ranges::is_permutation(each.effects, out.after().kinds()))
          each.evidence = evidence_between(request.runs, out.before(), out.after(), out.overdispersion);
    return out;
  }
}

}  // namespace coilwright::measurement::compare
