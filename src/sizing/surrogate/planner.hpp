#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <random>
#include <vector>

#include "sizing/sampling/goal.hpp"
#include "sizing/sampling/samples.hpp"
#include "sizing/surrogate/niches.hpp"
#include "sizing/surrogate/region.hpp"

namespace coilwright::sizing {

/// How a design came to be proposed.
enum class ProposalSource : std::size_t {
  gap,        ///< the model, to fill a gap of the front
  anchor,     ///< the model, to improve one objective or feasibility
  niche,      ///< the model, to improve one objective with a variable held at one level
  evolution,  ///< differential evolution or a grid step from good designs
  sobol       ///< a quasi-random point, or the next of a grid
};
inline constexpr std::size_t proposal_sources = 5;

/// A subproblem of the search: a goal, and the region in which to pursue it.
struct SubproblemTask {
  Goal goal;
  Region region{};
  ProposalSource source{};  ///< `gap`, `anchor` or `niche`
  std::size_t index{};      ///< of a gap's upper bound; of the objective; for feasibility the number of objectives
};

/// Chooses the subproblems of the next round: while nothing is feasible, feasibility; for a front, each objective alone
/// (anchors), niches and the largest gaps; for one objective, anchors and niches.
class Planner {
 public:
  /// `samples` and `random` must outlive it; numbers are drawn in a fixed order.
  Planner(const Samples& samples, std::mt19937_64& random);

  /// At most `wanted` subproblems for the round of number `round`.
  [[nodiscard]] std::vector<SubproblemTask> plan(std::size_t wanted, std::size_t round);

  /// Takes in the gain of a design (`Samples::add`) that the anchor of an objective proposed. After failures that
  /// anchor starts elsewhere, and less often.
  void count_anchor(std::size_t objective, double gain);

 private:
  [[nodiscard]] std::vector<SubproblemTask> gaps(std::size_t wanted);
  [[nodiscard]] std::vector<SubproblemTask> anchors(std::size_t wanted);
  [[nodiscard]] std::vector<SubproblemTask> niches(std::size_t wanted);
  [[nodiscard]] std::vector<SubproblemTask> feasibility(std::size_t wanted) const;
  [[nodiscard]] Goal anchor_goal(std::size_t objective) const;
  [[nodiscard]] std::size_t best_of(std::size_t objective) const;
  [[nodiscard]] SubproblemTask anchor(std::size_t objective, std::size_t turn, std::size_t rank);
  [[nodiscard]] Region gap_region(const Goal& goal, const UpperBound& bound);
  [[nodiscard]] double single_span() const;
  /// The best evaluated samples under a goal, with a penalty on violation, of one combination of levels or of all. None
  /// lies within 0.1 of a better one of its combination in every axis.
  [[nodiscard]] std::vector<std::size_t> distinct_best(const Goal& goal, std::size_t count,
                                                       std::optional<std::uint64_t> combination) const;

  const Samples& samples_;
  std::mt19937_64& random_;
  std::vector<int> anchor_failures_;
  std::size_t anchor_turn_ = 0;
  Niches niches_;
  std::size_t niche_turn_ = 0;
};

}  // namespace coilwright::sizing
