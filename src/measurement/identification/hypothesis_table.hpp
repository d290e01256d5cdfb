#pragma once

#include <deque>
#include <span>
#include <string_view>
#include <vector>

#include "coilwright/measurement/identification/posterior.hpp"
#include "measurement/identification/fitted_hypothesis.hpp"
#include "measurement/identification/weighed_fit.hpp"

namespace coilwright::measurement::identification {

/// What hypotheses are compared on, and what they weigh before the records are seen.
struct Comparison {
  std::span<const replay::PreparedRun> runs{};
  std::vector<const actuator::EffectKind*> kinds{};  ///< that the rig may have, see log_prior()
  std::span<const Belief> beliefs{};
  actuator::RigScale scale{};
};

/// A fit of a hypothesis, and what it weighs.
struct TableEntry {
  FittedHypothesis fitted;
  WeighedFit weighed{};
  double promised{};  ///< how far its objective would still fall, were it as its derivatives say
  bool has_ended{};   ///< whether it was continued as far as it goes

  [[nodiscard]] std::vector<std::string_view> ids() const { return ids_of(fitted.kinds()); }
  /// What it still promises is less than decides anything: 0.1, or a thousandth of what it leaves far from the noise.
  [[nodiscard]] bool is_at_optimum() const;
  /// A fall of the objective that decides nothing.
  [[nodiscard]] double negligible_fall() const;
};

/// Hypotheses with what was found of each.
struct WeighedHypotheses {
  Posterior posterior{};
  std::vector<WeighedFit> weighed{};            ///< of each hypothesis of the posterior
  std::vector<const FittedHypothesis*> fits{};  ///< likewise; in the table
};

/// Every fit of a comparison. The weight of a hypothesis, which is its evidence and its prior, is all by which it is
/// ranked, continued, extended and reported. Entries stay where they are.
class HypothesisTable {
 public:
  explicit HypothesisTable(Comparison with) : with_(std::move(with)) {}

  /// Weighs further fits, the first of all being the model without effects.
  void add(std::vector<FittedHypothesis> fits, bool have_ended);

  [[nodiscard]] std::deque<TableEntry>& entries() { return entries_; }
  [[nodiscard]] const Comparison& with() const { return with_; }

  /// The best fit of each hypothesis, the heaviest first. Of two fits of one hypothesis the lower one is better as long
  /// as the other has not reached an optimum; of two optima the heavier one is.
  [[nodiscard]] std::vector<const TableEntry*> hypotheses() const;
  /// The best fit of a hypothesis; null if it was not fitted.
  [[nodiscard]] const TableEntry* best_of(const std::vector<std::string_view>& ids) const;

  /// The logarithm of the weight, up to a constant. Where the most probable hypothesis lacks something, none is true,
  /// and the evidence of each is raised to a power below 1: share().
  [[nodiscard]] double log_weight(const TableEntry& entry) const;
  /// The same of the fit, once it has fallen as far as it promises: no further than it has come from the hypotheses
  /// with fewer of its effects, or than other optima are away; and no further below the lowest of all than these.
  [[nodiscard]] double promise(const TableEntry& entry) const;
  /// The same of a hypothesis with these effects that was not fitted, whose evidence is over that of an entry by so
  /// much.
  [[nodiscard]] double promise(const TableEntry& entry, const std::vector<const actuator::EffectKind*>& effects,
                               double further_evidence) const;
  /// Least weight, as a logarithm, of what is worth a fit: SearchEffort::least_weight of that of the heaviest.
  [[nodiscard]] double worth_a_fit() const;
  /// As if the records told as much of what is missing as 30 independent values of it (Miller and Dunson, J. Am. Stat.
  /// Assoc. 114 (2019) 1113: coarsening). A discrepancy is no process that time makes anew: what a model lacks comes
  /// back with every motion like the last one, and so does what a wrong effect can make of it.
  [[nodiscard]] double share() const { return share_; }
  /// Whether the heaviest hypothesis leaves noise.
  [[nodiscard]] bool leaves_noise() const;

  [[nodiscard]] WeighedHypotheses posterior() const;

 private:
  [[nodiscard]] bool is_better(const TableEntry& one, const TableEntry& other) const;

  Comparison with_;
  std::deque<TableEntry> entries_{};
  double share_ = 1.0;
};

/// The natural logarithm of the prior probability of a hypothesis whose effects are among `kinds`: one half for none,
/// half as much for each effect more, shared among all hypotheses of a size (Scott and Berger, Ann. Stat. 38 (2010)
/// 2587). An effect shares its part with itself with further numbers (EffectKind::with_further_numbers). A belief
/// multiplies the odds of all hypotheses with its effect: by its own over those of one effect of `kinds`, whose prior
/// probability is one over their number.
[[nodiscard]] double log_prior(const std::vector<const actuator::EffectKind*>& effects,
                               const std::vector<const actuator::EffectKind*>& kinds,
                               std::span<const Belief> beliefs = {});

}  // namespace coilwright::measurement::identification
