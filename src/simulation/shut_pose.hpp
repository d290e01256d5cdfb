#pragma once

#include <optional>
#include <string>
#include <vector>

#include "coilwright/actuator/design/layout.hpp"
#include "coilwright/simulation/evaluate.hpp"

namespace coilwright::simulation {

/// A pose of a free finger of which joints are shut: under its current or, where none is under it, at rest.
struct ShutPose {
  std::vector<int> at_rest;              ///< the joints that are pressed without current
  std::vector<int> under_current;        ///< those under it
  const mechanics::JointVector& angles;  ///< of the pose, rad; lives as long as the design
  double current{};                      ///< in it, A

  /// The joints that are pressed in it; one at least.
  [[nodiscard]] const std::vector<int>& joints() const { return under_current.empty() ? at_rest : under_current; }
};

/// Nothing where every joint of the free finger is open, and where it has no motion.
[[nodiscard]] std::optional<ShutPose> shut_pose(const DesignView& design);

/// "coil 2": a part of a row by its number among those of its kind, from the base.
[[nodiscard]] std::string part_name(const actuator::Layout& layout, std::size_t part);

/// "magnet 1, coil 2 and coil 3"
[[nodiscard]] std::string listed(const std::vector<std::string>& names);

/// The bodies of a pair by their places in the row: a segment a joint, and the first part in the base.
struct Bodies {
  std::size_t first{};
  std::size_t second{};
};

/// Those of a pair that may be far apart.
[[nodiscard]] Bodies bodies_of(const actuator::DistantPair& pair);

/// The magnets that attract each other most across the first joint that magnets close; nothing where none does.
[[nodiscard]] std::optional<Bodies> magnets_that_shut(const DesignView& design, const ShutPose& pose);

}  // namespace coilwright::simulation
