#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>
#include <string_view>
#include <vector>

#include "measurement/identification/hypothesis_table.hpp"
#include "measurement/identification/linear_screening.hpp"
#include "measurement/identification/staged_fit.hpp"

namespace coilwright::measurement::identification {

/// Where a fit of a hypothesis ended in a comparison that was begun anew.
struct KnownPlace {
  std::vector<actuator::Effect> effects{};
  Eigen::VectorXd values{};  ///< of the parameters of the hypothesis
};

/// Why a fit is begun.
enum class StartKind {
  from_another,   ///< where another hypothesis has ended
  other_optimum,  ///< another start of the same hypothesis
  own,            ///< a start of the only effect of a hypothesis, at the declared numbers
  larger          ///< effects that a screening promises much of
};

/// A fit that is to be made. Refers to the table.
struct Start {
  PlannedFit plan;
  StartKind kind{};
  const TableEntry* target{};     ///< the best fit of the same hypothesis; null: there is none
  const TableEntry* reference{};  ///< from whose numbers it starts
};

/// What a search begins fits with.
struct SearchWith {
  std::span<const actuator::EffectKind* const> tested{};  ///< effects that show in these records
  std::span<const ScreenedEffect> screened{};             ///< beside the model without effects
  std::span<const KnownPlace> known{};                    ///< of a comparison that was begun anew
  std::uint64_t seed = 1;
  bool extends = true;  ///< false: no other optima and no larger hypotheses
};

/// The starts that the table suggests, none of them twice.
/// - Each hypothesis that may hold SearchEffort::least_weight, and the model without effects, starts from the numbers
///   of each other one; without one of its effects it starts from its own; with one effect exchanged for another whose
///   first number has the same unit it takes that number over (one lag for another, one friction for another).
/// - What is worse than a hypothesis with fewer effects, which it can do whatever these can, starts there.
/// - The heaviest start from elsewhere: other discrete choices, the declared numbers, reached limits, further numbers.
/// - Single effects near the least start from where they do alone, if the first fits have not begun there.
/// - Larger hypotheses whose screening promises SearchEffort::least_weight: one effect more than the heaviest, and
///   pairs and triples of effects beside the model without, whose parts need explain nothing alone.
class SearchStarts {
 public:
  /// Refers to `table` and to what `with` refers to.
  SearchStarts(const HypothesisTable& table, SearchWith with) : table_(table), with_(with) {}

  [[nodiscard]] std::vector<Start> next();

 private:
  struct Candidate {
    const TableEntry* base{};
    const FittedHypothesis* from{};  // the fit of the base, or a variant of it
    std::vector<actuator::Effect> effects{};
    double evidence{};  // predicted, over that of the base
    bool is_certain{};  // fitted whatever it promises
  };

  void add(std::vector<Start>& out, Start start);
  void add_from(std::vector<Start>& out, std::vector<actuator::Effect> effects, const TableEntry& from,
                const TableEntry* target);
  void add_from_others(std::vector<Start>& out);
  void add_fewer_or_exchanged(std::vector<Start>& out, const TableEntry& from);
  void add_next_to_absent(std::vector<Start>& out, const TableEntry& target, const TableEntry& from);
  void add_known(std::vector<Start>& out);
  [[nodiscard]] double least_objective() const;
  void add_other_optima(std::vector<Start>& out);
  void add_own(std::vector<Start>& out, const TableEntry& target);
  void add_larger(std::vector<Start>& out);
  void screen_beside(const TableEntry& base, bool every_kind);
  void screen_together();
  void add_combinations(const FittedHypothesis& from, std::span<const ScreenedEffect> screened);
  [[nodiscard]] std::vector<actuator::Effect> exchanged(const actuator::Effect& effect) const;
  [[nodiscard]] std::vector<FittedHypothesis> less_damped() const;
  [[nodiscard]] double evidence_of(const actuator::Effect& effect, double direction, double share) const;

  const HypothesisTable& table_;
  SearchWith with_;
  std::vector<const TableEntry*> all_{}, heavy_{};  // the heaviest first
  const TableEntry* without_{};
  struct Tried {
    std::vector<std::string_view> ids;
    Eigen::VectorXd place;
  };
  std::vector<Tried> tried_{};
  std::vector<std::vector<std::string_view>> reconsidered_{}, extended_{};
  std::vector<Candidate> candidates_{};
  std::deque<FittedHypothesis> variants_{};  // to which candidates refer
  bool extended_noise_ = false;              // whether larger hypotheses were begun beside one that leaves noise
  std::size_t together_ = 1;                 // size of the largest combinations that were screened
};

/// Whether two effects are of one kind and make the same discrete choices.
[[nodiscard]] bool make_same_choices(const std::vector<actuator::Effect>& one,
                                     const std::vector<actuator::Effect>& other);

/// The rise of the objective from where a fit ended to a place, as its derivatives predict it.
[[nodiscard]] double predicted_rise(const FittedHypothesis& fitted, const Eigen::VectorXd& place);

/// Whether a start is of the hypothesis of its target, with the same numbers and choices.
[[nodiscard]] bool is_elsewhere_in(const Start& start);

}  // namespace coilwright::measurement::identification
