#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "sizing/sampling/samples.hpp"
#include "sizing/surrogate/region.hpp"

namespace coilwright::sizing {

/// Niches: the designs that share one level of a variable with few levels (a grid axis, or the combination of
/// categorical levels). Each niche keeps a best design of its own for each objective, so that a search can go on there
/// when the best of all designs has nothing left to gain: where a limit couples such a variable with others, every
/// level has its own optimum, and no single step leads from one to the next.
class Niches {
 public:
  /// Largest number of grid points of an axis with niches, and of combinations of levels.
  static constexpr std::uint64_t max_levels = 16;

  /// `samples` must outlive it.
  explicit Niches(const Samples& samples);

  [[nodiscard]] bool empty() const { return niches_.empty(); }

  /// Takes in what `samples` learnt since the last call. A niche whose best design improved has no failures any more.
  void learn();

  /// A niche as a place to search in.
  struct Place {
    std::optional<Level> level{};       ///< what is held fixed; empty for a combination of levels
    std::optional<std::size_t> best{};  ///< its best sample: feasible ones first, then by the objective
    /// Of the infeasible samples with a better objective than `best` the one that violates least: the limits run
    /// between the two. Only if `best` is feasible.
    std::optional<std::size_t> least_violating{};
    int failures{};  ///< number of searches there since its best design improved
  };

  /// Niches that hold the best design of all, where the model is most accurate, or all others.
  enum class Selection { with_best, without_best };
  /// The niche in which to search next for an objective; counts that search as a failure until `learn` finds an
  /// improvement. Axes take turns, because niches of different axes overlap around the best design. Of one axis it is
  /// the niche with the fewest failures, where a worse rank by the best design counts like half a failure. Empty if
  /// there is none.
  [[nodiscard]] std::optional<Place> take_next(Selection selection, std::size_t objective);

 private:
  struct Niche {
    std::size_t group{};  ///< index of the axis among those with niches
    std::optional<Level> level;
    std::uint64_t combination{};  ///< if `level` is empty
    std::vector<std::optional<std::size_t>> best;
    std::vector<int> failures;
  };
  [[nodiscard]] Niche* most_promising(std::size_t group, Selection selection, std::size_t objective);
  [[nodiscard]] std::optional<std::size_t> least_violating(const Niche& niche, std::size_t objective) const;
  [[nodiscard]] bool holds(const Niche& niche, const Sample& sample) const;
  [[nodiscard]] bool better(const Sample& sample, const Sample& than, std::size_t objective) const;
  [[nodiscard]] bool holds_best(const Niche& niche, std::size_t objective) const;

  const Samples& samples_;
  std::vector<Niche> niches_;
  std::size_t groups_ = 0, learnt_ = 0;
  std::vector<std::size_t> turns_;  // for each objective, with and without the best design
};

}  // namespace coilwright::sizing
