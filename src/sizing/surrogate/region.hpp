#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "sizing/sampling/samples.hpp"

namespace coilwright::sizing {

/// One value of one unit coordinate.
struct Level {
  std::size_t axis{};
  double value{};  ///< on the grid
};

/// Where a local model is built: around the segment between two samples of one combination of levels.
struct Region {
  std::size_t from{}, to{};  ///< indices of the samples, which may be the same
  double margin = 0.3;       ///< how far beyond its nodes the model is used, relative to the nodes' range
  /// Above 0: how far from the segment the model is used, relative to the box of its nodes.
  double trust = 0;
  bool interpolated = false;     ///< no model: a point between two designs of the front on either side of the goal
  double node_spacing = 0;       ///< smallest `largest_difference` between nodes; above 0 for a coarse, wide model
  std::uint64_t seed = 0;        ///< of random starts in the region; 0: no random starts
  std::optional<Level> level{};  ///< a coordinate held fixed, also where `from` and `to` have another value
};

/// The unit coordinates of a sample, moved to the level of the region.
[[nodiscard]] inline std::vector<double> at_level(const Region& region, const Sample& sample) {
  std::vector<double> unit = sample.unit;
  if (region.level) unit[region.level->axis] = region.level->value;
  return unit;
}

}  // namespace coilwright::sizing
