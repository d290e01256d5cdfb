#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "sizing/sampling/goal.hpp"
#include "sizing/sampling/samples.hpp"

namespace coilwright::sizing {

/// A design not evaluated yet.
struct Candidate {
  std::vector<double> unit;
  std::uint64_t combination{};
};

/// One value of one unit coordinate.
struct Level {
  std::size_t axis{};
  double value{};  ///< on the grid
};

/// Where the model is built: around the segment between two samples of one combination of levels.
struct Region {
  std::size_t from{}, to{};      ///< samples; may be the same
  double margin = 0.3;           ///< how far beyond its nodes the model is trusted, over the nodes' range
  double apart = 0;              ///< least distance between nodes (largest coordinate): a coarse model of a wide region
  std::uint64_t seed = 0;        ///< not 0: starts from random points of the region too
  std::optional<Level> level{};  ///< held fixed: the designs wanted have it, whether `from` and `to` have it or not
};

/// Designs the local model expects to reach the goal, best first, none known already, at most three. Fits the model to
/// the archive around `region`, minimises the goal on it with NLopt, and on a grid moves to the best unknown grid
/// points near the optimum. Empty if the model expects no progress. Pure.
[[nodiscard]] std::vector<Candidate> infill(const Samples& samples, const Goal& goal, const Region& region);

/// At most `count` unknown designs one or two grid steps from sample `of` in one variable, or at most three in two:
/// first those about which the model round `of` would have to be least wrong for them to beat the goal. Empty without a
/// grid and in more than ten dimensions. Pure.
[[nodiscard]] std::vector<Candidate> near_misses(const Samples& samples, const Goal& goal, std::size_t of,
                                                 std::size_t count);

}  // namespace coilwright::sizing
