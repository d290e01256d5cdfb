#pragma once

#include <cstddef>

#include "coilwright/thermal/network.hpp"

namespace coilwright::thermal {

/// The coil or magnet whose hottest place is farthest above its limit, or nearest to it.
struct HottestSpot {
  double excess{};  ///< above the limit, K
  std::size_t node{};
};
/// At mean `temperatures`, degC, a value a node.
[[nodiscard]] HottestSpot hottest_spot(const Network& network, const NodeVector& temperatures);

}  // namespace coilwright::thermal
