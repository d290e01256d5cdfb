#include "measurement/identification/hypothesis_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <memory>
#include <optional>
#include <utility>

#include "coilwright/measurement/identification/decision_thresholds.hpp"
#include "measurement/fit/outliers.hpp"
#include "measurement/fit/parallel.hpp"
#include "measurement/identification/first_fits.hpp"
#include "measurement/identification/hypothesis_extension.hpp"
#include "measurement/identification/hypothesis_table.hpp"
#include "measurement/identification/linear_screening.hpp"
#include "measurement/identification/model_error.hpp"
#include "measurement/identification/pace_of_fits.hpp"
#include "measurement/identification/recalibration.hpp"
#include "measurement/identification/rig_scale.hpp"
#include "measurement/identification/search_effort.hpp"
#include "measurement/identification/search_starts.hpp"
#include "measurement/identification/settled_model_error.hpp"
#include "measurement/identification/staged_fit.hpp"
#include "measurement/identification/started_fits.hpp"
#include "measurement/identification/window_subsample.hpp"

namespace coilwright::measurement::identification {
namespace {

using actuator::Effect;
using actuator::EffectKind;
using actuator::Model;

using Screened = std::vector<ScreenedEffect>;

std::string names(const FittedHypothesis& fitted) {
  std::string out;
  for (const EffectKind* kind : fitted.kinds()) {
    if (!out.empty()) out += " + ";
    out += kind->id();
  }
  return out.empty() ? "no effect" : out;
}

std::string effects_text(std::size_t count) {
  return fmt::format("{} effect{}", count, count == 1 ? "" : "s");
}

// Of the short fits from all planned starts: a step costs one, and one for each number of the effect.
std::size_t simulations_of(std::span<const PlannedExtension> planned) {
  std::size_t out = 0;
  for (const PlannedExtension& each : planned)
    for (const std::vector<Effect>& start : each.starts)
      out += static_cast<std::size_t>(search_effort.short_fit.iterations) * (1 + start.front().values.size());
  return out;
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
  // While `may_find_outliers`, the search ends where the heaviest hypothesis shows more of them. While
  // `may_weigh_priors`, the runs get the model error of the recalibrated model if that is far from the noise, and long
  // records are searched in part.
  // `known`: where the fits of a comparison ended; they start another one, too.
  HypothesisSearch(const AttributionRequest& request, bool may_find_outliers, bool may_weigh_priors,
                   std::vector<KnownPlace>& known)
      : request_(request),
        known_(known),
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
    tested_ = kinds_;
    recalibrated_ = &before;
    begin_table(before);
    // Known before it is told: who interrupts at the line has it.
    make_known();
    report(fmt::format("recalibrated: rms residual {:.3g} times the noise", before.whiteness.level));
    const std::optional<FittedHypothesis> on_some = on_subsample_if_far(before);
    if (on_some) begin_table(*on_some);
    compare();
    std::vector<RuledOut> on_some_only;
    if (on_some && !found_outliers_) on_some_only = back_on_all_windows(before);
    remember();
    if (found_outliers_) return std::nullopt;

    WeighedHypotheses weighed = table_->posterior();
    Answer answer = answer_of(weighed.posterior);
    Attribution out{.before = table_->best_of({})->fitted,
                    .after = *weighed.fits[answer.reported],
                    .kinds = tested_,
                    .scale = scale_};
    for (const std::size_t rival : answer.rivals) out.rivals.push_back(*weighed.fits[rival]);
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

  // `fits` begins fits and says of how many. They are announced with the time that those before let expect.
  bool at_pace(PaceOfFits& pace, std::string_view what, const std::function<bool(const FitsBegin&)>& fits) const {
    const auto begun = PaceOfFits::Clock::now();
    std::size_t count = 0;
    const bool any = fits([&](std::size_t more) {
      count = more;
      if (more > 0) report(fmt::format("{} {}{}", more, what, pace.text(more)));
    });
    pace.add(count, PaceOfFits::Clock::now() - begun);
    return any;
  }

  void begin_table(const FittedHypothesis& without) {
    table_ = std::make_unique<HypothesisTable>(
        Comparison{.runs = runs_, .kinds = kinds_, .beliefs = request_.beliefs, .scale = scale_});
    table_->add({without}, true);
  }

  // Every effect alone, and then what the table suggests, until nothing promises SearchEffort::least_weight.
  void compare() {
    const FittedHypothesis& without = table_->entries().front().fitted;
    const auto begun = PaceOfFits::Clock::now();
    Screened screened = screen_effects(runs_, without, {.kinds = tested_, .scale = scale_});
    simulations_.add(screened.size(), PaceOfFits::Clock::now() - begun);
    leave_out_untested(screened);
    fit_single_effects(without, screened);
    settle(screened, true);
  }

  // `extends`: with other optima and larger hypotheses.
  void settle(std::span<const ScreenedEffect> screened, bool extends) {
    SearchStarts starts(
        *table_, {.tested = tested_, .screened = screened, .known = known_, .seed = request_.seed, .extends = extends});
    while (true) {
      const auto continued = [&](const FitsBegin& begin) { return continue_promising(*table_, begin); };
      while (at_pace(to_their_ends_, "promising fits go on to their ends", continued)) {
      }
      make_known();
      const TableEntry& best = *table_->hypotheses().front();
      report(fmt::format("{} hypotheses fitted, the most probable so far: {}, {:.3g} times the noise",
                         table_->hypotheses().size(), names(best.fitted), best.fitted.whiteness.level));
      if (shows_more_outliers()) return;
      const auto started = [&](const FitsBegin& begin) { return fit_from(starts.next(), *table_, begin); };
      if (table_->hypotheses().size() >= search_effort.most_hypotheses ||
          !at_pace(short_fits_, "short fits from other starts", started))
        break;
    }
  }

  void remember() {
    known_.clear();
    for (const TableEntry* each : table_->hypotheses())
      known_.push_back(
          {.effects = each->fitted.hypothesis.effects_at(each->fitted.fit.values), .values = each->fitted.fit.values});
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

  void fit_single_effects(const FittedHypothesis& without, const Screened& screened) {
    std::vector<PlannedExtension> planned;
    for (const EffectKind* kind : tested_) {
      PlannedExtension each = one_more(without, kind, screened, search_effort.own_starts);
      const auto known = std::ranges::find_if(known_, [&](const KnownPlace& place) {
        return place.effects.size() == 1 && place.effects.front().kind == kind;
      });
      if (known != known_.end()) {
        each.starts.resize(std::min<std::size_t>(each.starts.size(), 1));
        each.starts.push_back(known->effects);
        each.further_starts.clear();
      }
      planned.push_back(std::move(each));
    }
    report(fmt::format("{} fitted alone{}", effects_text(planned.size()), simulations_.text(simulations_of(planned))));
    const auto begun = PaceOfFits::Clock::now();
    std::size_t reported = 0;
    FirstFits found = first_fits(runs_, planned, [&](std::size_t done) {
      if (done % 8 != 0 || done == reported) return;
      reported = done;
      PaceOfFits pace;
      pace.add(done, PaceOfFits::Clock::now() - begun);
      report(fmt::format("{} of {} effects compared{}", done, planned.size(),
                         done == planned.size() ? "" : pace.text(planned.size() - done) + " to go"));
    });
    table_->add(std::move(found.fits), false);
    std::ranges::move(found.failed, std::back_inserter(failed_));
  }

  // Whether the heaviest hypothesis shows samples that no motion can show, and enough of them to begin anew; they
  // are set aside then. Outliers hide others: what they pulled away is fitted again without them until it shows no
  // more, as a whole comparison for each such step would take minutes and find the same samples.
  [[nodiscard]] bool shows_more_outliers() {
    constexpr int most_steps = 4;
    if (!may_find_outliers_ || table_->leaves_noise()) return false;
    FittedHypothesis best = table_->hypotheses().front()->fitted;
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

  // The heaviest hypotheses go on with all windows.
  [[nodiscard]] std::vector<RuledOut> back_on_all_windows(const FittedHypothesis& before) {
    std::vector<FittedHypothesis> best;
    std::vector<RuledOut> others;
    for (const TableEntry* each : table_->hypotheses()) {
      if (each->fitted.hypothesis.effects().empty()) continue;
      if (best.size() < search_effort.judged_on_all)
        best.push_back(each->fitted);
      else
        others.push_back({.effects = each->fitted.kinds(),
                          .remark = fmt::format("was fitted to {} only, where others are better", subsample_->text())});
    }
    runs_ = request_.runs;
    report(fmt::format("the best {} hypotheses are fitted to all windows", best.size()));
    begin_table(before);
    known_.clear();
    table_->add(subsample_->on_all(best), true);
    settle({}, false);
    return others;
  }

  void make_known() {
    if (request_.known) request_.known(*recalibrated_, table_->posterior().posterior);
  }

  const AttributionRequest& request_;
  std::vector<KnownPlace>& known_;
  const FittedHypothesis* recalibrated_ = nullptr;
  std::unique_ptr<WindowSubsample> subsample_;  // null where the search uses all
  std::span<replay::PreparedRun> runs_;         // with all windows, or some
  actuator::RigScale scale_;
  std::vector<const EffectKind*> kinds_;   // that this rig may have
  std::vector<const EffectKind*> tested_;  // and that show in these records
  std::unique_ptr<HypothesisTable> table_;
  std::vector<RuledOut> failed_, untested_;
  PaceOfFits simulations_{}, short_fits_{}, to_their_ends_{};
  bool may_find_outliers_;
  bool may_weigh_priors_;
  bool found_outliers_ = false;
};

}  // namespace

Attribution attribute(const AttributionRequest& request) {
  constexpr int most_restarts = 2;
  const auto say = [&](const char* line) {
    if (request.progress) request.progress(line);
  };
  int restarts = 0;
  bool may_weigh_priors = true;
  std::vector<KnownPlace> known;
  while (true) {
    std::optional<Attribution> found =
        HypothesisSearch(request, restarts < most_restarts, may_weigh_priors, known).run();
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
      continue;
    }
    return with_settled_model_error(request.runs, std::move(*found));
  }
}

}  // namespace coilwright::measurement::identification
