#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "coilwright/measurement/planning/experiment.hpp"
#include "coilwright/measurement/replay/declared_model.hpp"

namespace coilwright::measurement::planning {

/// How much of an effect an experiment would show.
struct VisibleEffect {
  /// With its smallest strength that would be found; if none would be, as strong as it was tried. Its shape (a time
  /// constant, a side) is the one of its starts that shows best.
  actuator::Effect effect{};
  std::optional<std::size_t> main{};  ///< index of the number that is its strength; nothing: it is there or not
  bool visible{};                     ///< whether four twins in five would name it, or have it in the set
  double over_limit{};   ///< what it changes at that strength, over what must be changed; about 1 if visible
  std::string remark{};  ///< why it is never found; empty if it is
};

/// An effect that does not fit the rig, or that is declared already.
struct LeftOutEffect {
  const actuator::EffectKind* kind{};
  std::string reason{};
};

/// Two effects that the experiment cannot tell apart, each at five times its smallest strength.
struct InseparablePair {
  std::size_t first{}, second{};  ///< indices among ExperimentPlan::effects
  double cosine{};                ///< of what the two change in the records, nuisances projected out; -1 to 1
  double over_limit{};  ///< what the one changes and the other cannot imitate, over what tells them apart; < 1
};

/// A run that could be added, and what it would improve.
struct AddedRun {
  std::string kind{}, input{}, why{};  ///< for people
  PlannedRun run{};
  double lowering{};              ///< smallest strengths with it over those without, geometric mean; <= 1
  std::size_t newly_visible{};    ///< effects that are never found without it
  std::size_t separated_pairs{};  ///< inseparable pairs that come apart
};

/// What an experiment could show, before anything is recorded.
struct ExperimentPlan {
  std::size_t samples{};       ///< of all fit runs and channels
  double overdispersion{1.0};  ///< of noise alone, as a diagnosis of these records would take it; 1 for white noise
  std::vector<VisibleEffect> effects{};  ///< in the order of the catalogue
  std::vector<LeftOutEffect> left_out{};
  std::vector<InseparablePair> pairs{};   ///< the most alike first
  std::vector<AddedRun> added_runs{};     ///< the best first; empty if no run can be added
  std::vector<std::string> held_exact{};  ///< declared numbers that were taken as exact
  long simulated_runs{};
};

/// How a plan is made.
struct PlanOptions {
  int threads{};           ///< 0: as many as there are processors
  std::uint64_t seed = 1;  ///< of the noise from which the instruments' noise is estimated
  const actuator::EffectCatalogue& effects = actuator::standard_effects();
};

/// What a diagnosis of the fit runs of `experiment` on `rig` could show. Records of the rig as it is declared are
/// simulated and prepared as a diagnosis prepares them; every effect is added to the model, and what it changes in the
/// residuals is projected on what calibration, tolerances and local numbers (clocks, edges, initial states) cannot
/// absorb. An effect is visible where the length of that passes the limit of the quasi-BIC in 80 % of all noise.
/// The figures for added runs take changes as proportional to the strength. Equal input gives equal results on any
/// number of threads. Throws std::invalid_argument if the experiment does not fit the rig has no fit run, or
/// measures something without noise and resolution,
/// std::runtime_error if the rig cannot be simulated in it. Source: docs/how_to/plan_experiment.md.
[[nodiscard]] ExperimentPlan plan_experiment(const Experiment& experiment, const replay::DeclaredModel& rig,
                                             const PlanOptions& options = {});

}  // namespace coilwright::measurement::planning
