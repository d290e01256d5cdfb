#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "coilwright/actuator/modelling_choices.hpp"
#include "coilwright/simulation/choice_effects.hpp"
#include "coilwright/sizing/problem/archive.hpp"
#include "coilwright/sizing/problem/options.hpp"
#include "coilwright/sizing/study/design_problem.hpp"

namespace coilwright::sizing {

/// The limit that a design keeps with the least margin, or breaks by most.
struct WorstMargin {
  std::string limit;  ///< "mass_g <= 70"
  double margin{};    ///< distance from the limit over scale_of(limit); negative where it is broken
};

/// The worst limit of an evaluation of `study`; absent without limits or for a design that was not evaluated.
[[nodiscard]] std::optional<WorstMargin> worst_margin(const Study& study, const Evaluation& evaluation);

/// The answer of a study if one assumption is otherwise.
struct AssumptionEffect {
  actuator::OtherChoice choice;      ///< the choice; its design is the answer's own under it
  Evaluation evaluation;             ///< of the answer under the other choice
  std::optional<WorstMargin> worst;  ///< worst limit of that evaluation
  bool is_built = true;  ///< false: its model cannot be computed under the choice, which says nothing about the choice
  std::optional<Record> other_best;  ///< the best feasible design that a short search under it found; absent if none
  bool changes_design{};             ///< whether that design would be chosen instead
  std::size_t evaluations{};         ///< number of designs evaluated for all this
  double gain{};                     ///< gain of the objective, over its value in the answer; negative if it is worse

  /// Whether the answer depends on the assumption: it breaks a limit or has no figures, leads to another design, or
  /// changes the objective by simulation::change_that_matters.
  [[nodiscard]] bool matters() const;
};

/// Gain of a search under another choice from which on its design counts as another answer, relative to the objective.
inline constexpr double gain_of_another_design = 0.01;

/// The name of a choice among the others of its study: "hinge: beam".
[[nodiscard]] std::string name_of(const actuator::OtherChoice& choice);

/// The problem of a study whose own actuator is taken under another choice.
[[nodiscard]] DesignProblem under(const DesignProblem& problem, const actuator::OtherChoice& choice);

/// Settings of the searches under other choices.
struct AssumptionOptions {
  std::size_t evaluations = 300;  ///< of the search under each other choice; 0 for none
  SearchOptions search{};         ///< seed, threads and stop token of these searches
  /// Evaluates a point of `other`, which is the problem under `choice`; called from any thread. It may answer from a
  /// record. Empty: other.problem().evaluate.
  std::function<Evaluation(const DesignProblem& other, const actuator::OtherChoice& choice,
                           std::span<const double> point)>
      evaluate{};
  /// Called before each choice, on the caller's thread, with the number of choices done and the number of all. May be
  /// empty.
  std::function<void(std::size_t looked_at, std::size_t of)> progress{};
};

/// Number of entries that assumption_effects() has for the answer `best` if nothing stops it.
[[nodiscard]] std::size_t assumption_count(const DesignProblem& problem, const Record& best);

/// Evaluates the answer `best` of a study with one objective under every other modelling choice. Another design is
/// better there if the answer breaks a limit, or if a search that starts from the answer gains more than
/// `gain_of_another_design`. Then evaluates the answer with each number that is neither measured nor stated at its
/// other values, except those that scatter in the study's spread. The subject with the largest change or broken limit
/// comes first, each with its entries together. Choices whose search was stopped are left out. Pure except for the
/// clock of a stop.
[[nodiscard]] std::vector<AssumptionEffect> assumption_effects(const DesignProblem& problem, const Record& best,
                                                               const AssumptionOptions& options);

/// The effect that changes the answer most among those that a measurement settles: one that breaks a limit comes before
/// one that changes the objective; then the distance of the best design under it from the answer's promise decides, or
/// the excess over the worst limit if no other design was sought. nullptr if none changes it by more than
/// gain_of_another_design.
[[nodiscard]] const AssumptionEffect* decisive(const Study& study, const Record& best,
                                               const std::vector<AssumptionEffect>& effects);

}  // namespace coilwright::sizing
