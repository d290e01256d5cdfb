#include "measurement/identification/hypothesis_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <memory>
#include <optional>
#include <utility>

#include "coilwright/measurement/identification/decision_thresholds.hpp"
#include "measurement/fit/outliers.hpp"
#include "measurement/identification/hypothesis_extension.hpp"
#include "measurement/identification/joint_screening.hpp"
#include "measurement/identification/larger_hypotheses.hpp"
#include "measurement/identification/level_fits.hpp"
#include "measurement/identification/linear_screening.hpp"
#include "measurement/identification/model_error.hpp"
#include "measurement/identification/other_optima.hpp"
#include "measurement/identification/posterior.hpp"
#include "measurement/identification/recalibration.hpp"
#include "measurement/identification/rig_scale.hpp"
#include "measurement/identification/search_effort.hpp"
#include "measurement/identification/settled_fits.hpp"
#include "measurement/identification/settled_model_error.hpp"
#include "measurement/identification/staged_fit.hpp"
#include "measurement/identification/window_subsample.hpp"

namespace coilwright::measurement::identification {
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
  std::vector<RuledOut> inapplicable{};
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
  // `singles`: where a comparison with these outliers had its single effects.
  // `known`: where its fits ended; they start another comparison, too.
  HypothesisSearch(const AttributionRequest& request, bool may_find_outliers, bool may_weigh_priors,
                   std::vector<Effect>& singles, std::vector<KnownPlace>& known)
      : request_(request),
        singles_(singles),
        known_(known),
        runs_(request.runs),
        may_find_outliers_(may_find_outliers),
        may_weigh_priors_(may_weigh_priors) {}

  // Nothing if more outliers were set aside.
  std::optional<Attribution> run() {
    FittedHypothesis before = may_weigh_priors_ ? recalibrated_at_its_error(request_.runs, *request_.declared)
                                                : recalibrated(request_.runs, *request_.declared);
    const Model nominal = before.hypothesis.model_at(before.fit.values);
    scale_ = rig_scale(runs_, nominal);
    ApplicableKinds applicable = applicable_kinds(request_.effects, nominal);
    kinds_ = std::move(applicable.kinds);
    tested_ = kinds_;
    recalibrated_ = &before;
    if (request_.known) request_.known(before, first_impressions(before, {}, kinds_, request_.beliefs, 1.0));
    report(fmt::format("recalibrated: rms residual {:.3g} times the noise", before.whiteness.level));
    const std::optional<FittedHypothesis> on_some = on_subsample_if_far(before);
    compared_with_ = on_some ? &*on_some : &before;

    std::vector<FittedHypothesis> all = settled_from(on_some ? *on_some : before, compare_levels(*compared_with_));
    if (found_outliers_) return std::nullopt;
    std::vector<RuledOut> on_some_only;
    if (on_some) {
      all.erase(all.begin());
      const std::vector<FittedHypothesis> best = split_off_the_best(all, overdispersion_);
      for (const FittedHypothesis& each : std::exchange(all, back_on_all_windows(best)))
        on_some_only.push_back(
            {.effects = each.kinds(),
             .remark = fmt::format("was fitted to {} only, where others are better", subsample_->text())});
      all = settled_from(before, std::move(all));
    }
    before = all.front();
    all.erase(all.begin());
    WeighedHypotheses weighed = posterior_of(runs_, before, all, kinds_, scale_, request_.beliefs);
    const auto fit_of = [&](std::size_t place) -> const FittedHypothesis& {
      return weighed.fits[place] == 0 ? before : all[weighed.fits[place] - 1];
    };
    Answer answer = answer_of(weighed.posterior);
    Attribution out{.before = before, .after = fit_of(answer.reported), .kinds = tested_, .scale = scale_};
    for (const std::size_t rival : answer.rivals) out.rivals.push_back(fit_of(rival));
    out.posterior = std::move(weighed.posterior);
    out.weighed = std::move(weighed.weighed);
    out.answer = std::move(answer);
    for (auto* part : {&on_some_only, &applicable.inapplicable, &failed_, &untested_})
      std::ranges::move(*part, std::back_inserter(out.posterior.ruled_out));
    return out;
  }

 private:
  void report(const std::string& line) const {
    if (request_.progress) request_.progress(line);
  }

  // All hypotheses of one effect, two, ..., until one leaves white noise or another effect is not worth its runs.
  std::vector<FittedHypothesis> compare_levels(const FittedHypothesis& before) {
    Screened screened = screen(before);
    leave_out_untested(screened);
    HypothesesOfSize level = single_effects(before, screened);
    std::vector<FittedHypothesis> all;
    overdispersion_ = overdispersion_of(runs_, nearest_or(level, before));
    double above_noise = before.chi_square_above_noise();
    double of_the_size_before = before.fit.objective();
    for (std::size_t size = 1;; ++size) {
      sort(level);
      // Asked before runs are spent on the best of this level, and again of what these find.
      if (shows_more_outliers(level)) break;
      if (is_worth_other_starts(before, level, of_the_size_before))
        level = at_better_optima(std::move(level), of_the_size_before, size);
      if (!level.empty()) {
        const FittedHypothesis& best = level.front();
        overdispersion_ = std::min(overdispersion_, overdispersion_of(runs_, best));
        report(fmt::format("best with {}: {}: rms residual {:.3g} times the noise, whiteness ratio {:.2g}",
                           effects_text(size), names(best), best.whiteness.level, best.whiteness.structure));
      }
      if (shows_more_outliers(level)) break;
      all.insert(all.end(), level.begin(), level.end());
      // Where declared numbers alone leave noise, two effects would only share what the integrator leaves: a lag and
      // its opposite delay of 13 microseconds each "gained" 60 on a noisy torque.
      if (before.whiteness.is_white()) break;
      if (leaves_noise(level)) {
        fit_what_may_hold_weight(before, screened, all);
        break;
      }
      if (size == search_effort.largest_hypothesis) break;
      const double left = level.empty() ? above_noise : level.front().chi_square_above_noise();
      const bool worth_extending = size == 1 || left <= search_effort.worth_another_effect * above_noise;
      std::vector<ScreenedCombination> combined =
          combinations_by_predicted_fall(before, screened, size + 1, search_effort.combinations);
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

  // See settled(); the model without effects first.
  [[nodiscard]] std::vector<FittedHypothesis> settled_from(const FittedHypothesis& before,
                                                           std::vector<FittedHypothesis> all) {
    all.insert(all.begin(), before);
    if (!found_outliers_)
      all = settled({.runs = runs_,
                     .tested = tested_,
                     .kinds = kinds_,
                     .beliefs = request_.beliefs,
                     .scale = scale_,
                     .known = known_,
                     .progress = [this](const std::string& line) { report(line); }},
                    std::move(all));
    else
      std::ranges::stable_sort(all, {}, [](const FittedHypothesis& each) { return each.fit.objective(); });
    known_.clear();
    for (const FittedHypothesis& each : all)
      if (known_.size() < search_effort.heaviest)
        known_.push_back({.effects = each.hypothesis.effects_at(each.fit.values), .values = each.fit.values});
    return all;
  }

  // What these records do not test is in no hypothesis. That it may be on the rig is not less probable for that: the
  // priors of all others stay.
  void leave_out_untested(Screened& screened) {
    const std::vector<const EffectKind*> untested =
        untested_kinds(request_.runs, *recalibrated_, screened, {.kinds = kinds_, .scale = scale_});
    if (untested.empty()) return;
    for (const EffectKind* kind : untested)
      untested_.push_back({.effects = {kind}, .remark = std::string(not_tested_remark)});
    const auto is_untested = [&](const EffectKind* kind) {
      return std::ranges::find(untested, kind) != untested.end();
    };
    std::erase_if(tested_, is_untested);
    std::erase_if(screened, [&](const ScreenedEffect& each) { return is_untested(each.guess.kind); });
    report(fmt::format("{} not tested by these records", effects_text(untested.size())));
  }

  // An answer is there: see larger_hypotheses_with_weight.
  void fit_what_may_hold_weight(const FittedHypothesis& before, const Screened& screened,
                                std::vector<FittedHypothesis>& all) {
    const std::vector<PlannedExtension> planned = larger_hypotheses_with_weight(
        {.before = before,
         .all = all,
         .screened = screened,
         .screen = [this](const FittedHypothesis& base) { return screen(base); },
         .weight = {.kinds = kinds_, .beliefs = request_.beliefs, .overdispersion = overdispersion_}});
    if (planned.empty()) return;
    report(fmt::format("{} larger hypotheses may hold weight", planned.size()));
    HypothesesOfSize fitted = best_of(planned, planned.size());
    all.insert(all.end(), std::make_move_iterator(fitted.begin()), std::make_move_iterator(fitted.end()));
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
    return screen_effects(runs_, base, {.kinds = tested_, .scale = scale_});
  }

  // Every effect alone.
  [[nodiscard]] HypothesesOfSize single_effects(const FittedHypothesis& base, const Screened& screened) {
    std::vector<PlannedExtension> planned;
    for (const EffectKind* kind : tested_) {
      PlannedExtension each = one_more(base, kind, screened, search_effort.own_starts);
      const auto known = std::ranges::find(singles_, kind, &Effect::kind);
      if (known != singles_.end()) {
        each.starts.resize(std::min<std::size_t>(each.starts.size(), 1));
        each.starts.push_back({*known});
        each.further_starts.clear();
      }
      planned.push_back(std::move(each));
    }
    HypothesesOfSize out = best_of(planned, search_effort.refined_singles);
    singles_.clear();
    for (const FittedHypothesis& each : out) singles_.push_back(each.hypothesis.effects_at(each.fit.values).front());
    return out;
  }

  // Hypotheses with one effect more than those of `level` (sorted, best first), and `combined` effects added to `base`.
  [[nodiscard]] HypothesesOfSize larger_hypotheses(const FittedHypothesis& base, const HypothesesOfSize& level,
                                                   double of_the_size_before,
                                                   const std::vector<ScreenedCombination>& combined) {
    std::vector<PlannedExtension> planned;
    for (const std::size_t i : contenders(level, of_the_size_before, search_effort.beam)) {
      const Screened more = screen(level[i]);
      // What the numbers of a base have taken up of an effect the screening does not see: near the noise the best is
      // extended by each.
      if (i == 0 && !is_far_from_noise(level[i])) {
        for (const EffectKind* kind : kinds_beside(level[i]))
          planned.push_back(one_more(level[i], kind, more, search_effort.own_starts_of_more));
        continue;
      }
      for (const EffectKind* kind : kinds_by_predicted_fall(more, search_effort.extensions))
        planned.push_back(one_more(level[i], kind, more));
    }
    for (const ScreenedCombination& each : combined) planned.push_back({.base = &base, .starts = {each.effects}});
    return best_of(without_repetitions(std::move(planned)), search_effort.refined_extensions);
  }

  [[nodiscard]] std::vector<const EffectKind*> kinds_beside(const FittedHypothesis& base) const {
    std::vector<const EffectKind*> out;
    std::ranges::copy_if(tested_, std::back_inserter(out),
                         [&](const EffectKind* kind) { return !are_among({kind}, base.kinds()); });
    return out;
  }

  // See fit_level.
  [[nodiscard]] HypothesesOfSize best_of(const std::vector<PlannedExtension>& planned, std::size_t refined) {
    std::size_t reported = 0;
    LevelFits fits = fit_level(runs_, planned, refined, [&](std::size_t done, const ShortFit* latest) {
      if (latest != nullptr && request_.known) make_known(*latest);
      if (done % 8 == 0 && done != reported) report(fmt::format("{} of {} hypotheses compared", done, planned.size()));
      reported = done;
    });
    std::ranges::move(fits.failed, std::back_inserter(failed_));
    return std::move(fits.level);
  }

  // Of starts with several discrete choices the best one stands for the hypothesis.
  void make_known(const ShortFit& fit) {
    const FittedHypothesis fitted = score(runs_, fit.plan.hypothesis, fit.fitted);
    FirstImpression latest{.effects = fitted.kinds(),
                           .chi_square = fitted.fit.chi_square,
                           .criterion = quasi_bic(fitted, overdispersion_)};
    const auto known = std::ranges::find(so_far_, latest.effects, &FirstImpression::effects);
    if (known == so_far_.end())
      so_far_.push_back(std::move(latest));
    else if (latest.criterion < known->criterion)
      *known = std::move(latest);
    request_.known(*recalibrated_,
                   first_impressions(*compared_with_, so_far_, kinds_, request_.beliefs, overdispersion_));
  }

  const AttributionRequest& request_;
  std::vector<Effect>& singles_;
  std::vector<KnownPlace>& known_;
  const FittedHypothesis* recalibrated_ = nullptr;
  const FittedHypothesis* compared_with_ = nullptr;  // the same on the windows of the search
  std::vector<FirstImpression> so_far_;              // by short fits
  std::unique_ptr<WindowSubsample> subsample_;       // null where the search uses all
  std::span<replay::PreparedRun> runs_;              // with all windows, or some
  actuator::RigScale scale_;
  std::vector<const EffectKind*> kinds_;   // that this rig may have
  std::vector<const EffectKind*> tested_;  // and that show in these records
  std::vector<RuledOut> failed_, untested_;
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
  std::vector<Effect> singles;
  std::vector<KnownPlace> known;
  while (true) {
    std::optional<Attribution> found =
        HypothesisSearch(request, restarts < most_restarts, may_weigh_priors, singles, known).run();
    if (!found) {
      say("more outliers are certain now: the comparison begins anew without them");
      ++restarts;
      continue;
    }
    const double searched = replay::model_error_of(request.runs);
    const double left = model_error_of(request.runs, found->after);
    if (may_weigh_priors && left < search_effort.much_less_model_error * searched) {
      say("far less is left over than without effects: the comparison begins anew, weighed by what is left");
      set_model_error(request.runs, left);
      may_weigh_priors = false;
      singles.clear();
      continue;
    }
    return with_settled_model_error(request.runs, std::move(*found));
  }
}

}  // namespace coilwright::measurement::identification
