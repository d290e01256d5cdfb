#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "sizing/sampling/samples.hpp"
#include "sizing/surrogate/infill.hpp"

namespace coilwright::sizing {

/// The designs that share one level of a variable with few levels (a grid axis or a categorical one). Each keeps a best
/// design of its own for each objective, so that a search can go on there when the best of all has nothing left to
/// gain: where a limit couples such a variable with others, every level has its own optimum, and no single step leads
/// from one to the next.
class Niches {
 public:
  /// Axes with at most `most_levels` grid points have niches, and so have at most that many combinations of levels.
  static constexpr std::uint64_t most_levels = 16;

  /// `samples` outlives this.
  explicit Niches(const Samples& samples);

  [[nodiscard]] bool empty() const { return niches_.empty(); }

  /// Takes in what `samples` learnt since the last call. A niche whose best design got better starts afresh.
  void learn();

  /// A niche as a place to search in.
  struct Place {
    std::optional<Level> level{};       ///< what is held fixed; empty for a combination of levels
    std::optional<std::size_t> best{};  ///< its best sample: feasible before not, then by the objective
    /// The sample that violates least of those whose objective is better than that of `best`: the limits lie between
    /// the two. If `best` is feasible.
    std::optional<std::size_t> beyond{};
    int failures{};  ///< attempts there since its best got better
  };

  /// Niches that hold the best design of all, in which the model knows most, or the others.
  enum class Which { of_the_best, elsewhere };
  /// The axes take turns, as their niches are not to be compared: next to the best design there is always another
  /// nearly as good. Of one axis, the most promising niche for an objective, and one attempt there counted: fewest
  /// attempts in vain, the better ones before the others. Empty if there is none.
  [[nodiscard]] std::optional<Place> next(Which which, std::size_t objective);

 private:
  struct Niche {
    std::size_t group{};  ///< the axis, counted among those with niches
    std::optional<Level> level;
    std::uint64_t combination{};  ///< if `level` is empty
    std::vector<std::optional<std::size_t>> best;
    std::vector<int> failures;
  };
  [[nodiscard]] Niche* most_promising(std::size_t group, Which which, std::size_t objective);
  [[nodiscard]] std::optional<std::size_t> beyond(const Niche& niche, std::size_t objective) const;
  [[nodiscard]] bool holds(const Niche& niche, const Sample& sample) const;
  [[nodiscard]] bool better(const Sample& sample, const Sample& than, std::size_t objective) const;
  /// True if the best of all is in it.
  [[nodiscard]] bool holds_best(const Niche& niche, std::size_t objective) const;
  const Samples& samples_;
  std::vector<Niche> niches_;
  std::size_t groups_ = 0, learnt_ = 0;
  std::vector<std::size_t> turns_;  // per objective, of the best and elsewhere
};

}  // namespace coilwright::sizing
