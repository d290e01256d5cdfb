#pragma once

#include <cstdint>
#include <vector>

namespace coilwright::sizing {

/// A design in the coordinates of a DesignSpace.
struct UnitPoint {
  std::vector<double> unit;     ///< legal unit coordinates: in the unit cube and on the grid
  std::uint64_t combination{};  ///< of categorical levels
};

}  // namespace coilwright::sizing
