#include "coilwright/measurement/planning/experiment_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "measurement/fit/parallel.hpp"
#include "measurement/identification/rig_scale.hpp"
#include "measurement/planning/candidate_runs.hpp"
#include "measurement/planning/projected_changes.hpp"
#include "measurement/planning/smallest_strength.hpp"
#include "measurement/replay/if_possible.hpp"

namespace coilwright::measurement::planning {
namespace {

using actuator::EffectKind;
using actuator::Model;

// Pairs are compared where a benchmark asks for names: at five times the smallest strength.
constexpr double strength_of_pairs = 5.0;

std::vector<const EffectKind*> applicable_kinds(const actuator::EffectCatalogue& catalogue, const Model& nominal,
                                                std::vector<LeftOutEffect>& left_out) {
  std::vector<const EffectKind*> out;
  for (const EffectKind* kind : catalogue.kinds()) {
    const auto& declared = nominal.nominal_spec().effects;
    std::optional<std::string> reason = kind->inapplicable(nominal.nominal_spec());
    if (reason) reason->insert(0, "does not fit this rig: ");
    if (std::ranges::find(declared, kind, &actuator::Effect::kind) != declared.end())
      reason = "is in the declared model already";
    if (reason)
      left_out.push_back({.kind = kind, .reason = std::move(*reason)});
    else
      out.push_back(kind);
  }
  return out;
}

std::vector<InseparablePair> inseparable_pairs(const ProjectedChanges& changes,
                                               const std::vector<ComparedEffect>& effects,
                                               const DetectionLimit& limit) {
  std::vector<InseparablePair> out;
  // Whether `other` drops out of the set where `one` is the truth.
  const auto over_limit = [&](std::size_t one, std::size_t other) {
    return strength_of_pairs * changes.length_beyond(one, other) /
           limit.length(effects[one].numbers - effects[other].numbers);
  };
  for (std::size_t i = 0; i < effects.size(); ++i) {
    for (std::size_t j = i + 1; j < effects.size(); ++j) {
      if (!effects[i].visible || !effects[j].visible) continue;
      const double least = std::min(over_limit(i, j), over_limit(j, i));
      if (least < 1.0) out.push_back({.first = i, .second = j, .cosine = changes.cosine(i, j), .over_limit = least});
    }
  }
  std::ranges::stable_sort(out, {}, &InseparablePair::over_limit);
  return out;
}

// The still runs of an experiment, and one run.
Experiment only_with(const Experiment& experiment, const PlannedRun& run) {
  Experiment out{.name = experiment.name, .instruments = experiment.instruments, .runs = {run}};
  for (const PlannedRun& planned : experiment.runs)
    if (planned.plan.kind == data::RunKind::still) out.runs.push_back(planned);
  return out;
}

// Without noise every effect would be visible at any strength; rounding alone repeats itself and sets no limit.
void require_noise(const Experiment& experiment) {
  for (const PlannedRun& run : experiment.runs) {
    if (run.validate || run.plan.kind == data::RunKind::still || run.plan.sigma) continue;
    for (const data::Channel& channel : run.plan.channels) {
      const Instrument& instrument = experiment.instruments.of(channel.kind);
      if (instrument.noise > 0.0) continue;
      throw std::invalid_argument(
          fmt::format("{}: the instrument of {} must have a noise > 0, one standard deviation of a reading; got 0",
                      run.plan.name, channel.name));
    }
  }
}

class Planning {
 public:
  Planning(const Experiment& experiment, const replay::DeclaredModel& rig, const PlanOptions& options)
      : experiment_(experiment), rig_(rig), options_(options), records_(experiment, rig, options.seed, simulations_) {}

  ExperimentPlan run() {
    const identification::FittedHypothesis& base = records_.base();
    const Model nominal = base.hypothesis.model_at(base.fit.values);
    plan_.samples = base.fit.samples();
    plan_.overdispersion = identification::overdispersion_of(records_.runs(), base);
    plan_.held_exact = rig_.held_exact;
    find_strengths(applicable_kinds(options_.effects, nominal, plan_.left_out),
                   identification::rig_scale(records_.runs(), nominal));
    const ProjectedChanges changes(records_, compared_);
    plan_.pairs = inseparable_pairs(changes, compared_, limit_of(changes));
    plan_.simulated_runs = *simulations_;
    weigh_added_runs(changes, candidate_runs(experiment_, nominal, "added_"));
    return std::move(plan_);
  }

 private:
  [[nodiscard]] DetectionLimit limit_of(const ProjectedChanges& changes) const {
    return {.samples = changes.samples(), .overdispersion = plan_.overdispersion};
  }

  void find_strengths(const std::vector<const EffectKind*>& kinds, const actuator::RigScale& scale) {
    const DetectionLimit limit{.samples = static_cast<double>(plan_.samples), .overdispersion = plan_.overdispersion};
    std::vector<SmallestStrength> found(kinds.size());
    fit::in_parallel(kinds.size(),
                     [&](std::size_t i) { found[i] = smallest_strength(records_, *kinds[i], scale, limit); });
    for (SmallestStrength& each : found) {
      compared_.push_back(
          {.effect = each.effect, .visible = each.visible, .numbers = records_.numbers_of(each.effect)});
      plan_.effects.push_back({.effect = std::move(each.effect),
                               .main = main_number(*compared_.back().effect.kind),
                               .visible = each.visible,
                               .over_limit = each.over_limit,
                               .remark = std::move(each.remark)});
    }
  }

  void weigh_added_runs(const ProjectedChanges& without, std::vector<CandidateRun> candidates) {
    for (CandidateRun& each : candidates) {
      AddedRun candidate{.kind = std::move(each.kind),
                         .input = std::move(each.input),
                         .why = std::move(each.why),
                         .run = std::move(each.run)};
      // A run that the declared rig cannot follow is no proposal, nor is one that this rig cannot have: a voltage on
      // another wiring, a camera that sees nothing move.
      const auto refusal = replay::refusal_of([&] {
        const auto simulations = std::make_shared<std::atomic<long>>();
        const LinearisedRecords more(only_with(experiment_, candidate.run), rig_, options_.seed, simulations);
        const ProjectedChanges alone(more, compared_);
        plan_.simulated_runs += *simulations;
        weigh(candidate, without, without.with(alone));
      });
      if (!refusal) plan_.added_runs.push_back(std::move(candidate));
    }
    std::ranges::stable_sort(plan_.added_runs, [](const AddedRun& a, const AddedRun& b) {
      const std::size_t gain_a = a.newly_visible + a.separated_pairs;
      const std::size_t gain_b = b.newly_visible + b.separated_pairs;
      return gain_a != gain_b ? gain_a > gain_b : a.lowering < b.lowering;
    });
  }

  void weigh(AddedRun& candidate, const ProjectedChanges& without, const ProjectedChanges& with) const {
    const DetectionLimit before = limit_of(without);
    const DetectionLimit after = limit_of(with);
    double sum = 0.0;
    double count = 0.0;
    for (std::size_t i = 0; i < compared_.size(); ++i) {
      const double over_before = without.length(i) / before.length(compared_[i].numbers);
      const double over_after = with.length(i) / after.length(compared_[i].numbers);
      if (compared_[i].visible && over_before > 0.0 && over_after > 0.0) {
        sum += std::log(over_before / over_after);
        count += 1.0;
      }
      if (!compared_[i].visible && over_after >= 1.0) ++candidate.newly_visible;
    }
    candidate.lowering = count > 0.0 ? std::exp(sum / count) : 1.0;
    const std::size_t left = inseparable_pairs(with, compared_, after).size();
    candidate.separated_pairs = plan_.pairs.size() > left ? plan_.pairs.size() - left : 0;
  }

  const Experiment& experiment_;
  const replay::DeclaredModel& rig_;
  const PlanOptions& options_;
  replay::SimulationCount simulations_ = std::make_shared<std::atomic<long>>();
  LinearisedRecords records_;
  std::vector<ComparedEffect> compared_;
  ExperimentPlan plan_;
};

}  // namespace

ExperimentPlan plan_experiment(const Experiment& experiment, const replay::DeclaredModel& rig,
                               const PlanOptions& options) {
  ExperimentPlan out;
  require_noise(experiment);
  fit::with_threads(options.threads, [&] { out = Planning(experiment, rig, options).run(); });
  return out;
}

}  // namespace coilwright::measurement::planning
