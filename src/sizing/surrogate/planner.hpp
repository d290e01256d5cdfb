#pragma once

#include <cstddef>
#include <optional>
#include <random>
#include <vector>

#include "sizing/sampling/samples.hpp"
#include "sizing/surrogate/infill.hpp"
#include "sizing/surrogate/niches.hpp"

namespace coilwright::sizing {

/// How a design came to be proposed.
enum class Way : std::size_t { gap, anchor, niche, breed, scatter };
inline constexpr std::size_t ways = 5;

/// A goal and where to pursue it.
struct Attempt {
  Goal goal;
  Region region{};
  Way way{};            ///< `gap`, `anchor` or `niche`
  std::size_t which{};  ///< upper bound of a gap; objective of an anchor, or their number for feasibility
};

/// Chooses what the next round pursues: anchors and the largest gaps of the front, feasibility while nothing is
/// feasible.
class Planner {
 public:
  /// Both outlive the planner; `random` is drawn from in a fixed order.
  Planner(const Samples& samples, std::mt19937_64& random);

  /// At most `wanted` attempts for round number `round`.
  [[nodiscard]] std::vector<Attempt> plan(std::size_t wanted, std::size_t round);

  /// Learns what an attempt at an anchor gained (as `Samples::add`); after failures it starts elsewhere, and less
  /// often.
  void count_anchor(std::size_t objective, double gain);

 private:
  void add_gaps(std::vector<Attempt>& list, std::size_t wanted);
  void add_anchors(std::vector<Attempt>& list, std::size_t wanted);
  void add_niches(std::vector<Attempt>& list, std::size_t wanted);
  void add_feasibility(std::vector<Attempt>& list, std::size_t wanted) const;
  [[nodiscard]] Goal anchor_goal(std::size_t objective) const;
  [[nodiscard]] std::size_t best_of(std::size_t objective) const;
  [[nodiscard]] Attempt anchor(std::size_t objective, std::size_t turn, std::size_t rank);
  [[nodiscard]] Region gap_region(const Goal& goal, const UpperBound& bound);
  [[nodiscard]] double single_span() const;
  /// Best evaluated samples under a goal, violation priced in, in one combination of levels or all; none within 0.1 of
  /// a better one of its combination in every axis.
  [[nodiscard]] std::vector<std::size_t> best_apart(const Goal& goal, std::size_t count,
                                                    std::optional<std::uint64_t> combination) const;

  const Samples& samples_;
  std::mt19937_64& random_;
  std::vector<int> anchor_failures_;
  std::size_t anchor_turn_ = 0;
  Niches niches_;
  std::size_t niche_turn_ = 0;
};

}  // namespace coilwright::sizing
