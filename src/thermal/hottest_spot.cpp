#include "hottest_spot.hpp"

#include <limits>

namespace coilwright::thermal {

HottestSpot hottest_spot(const Network& network, const NodeVector& temperatures) {
  const NodeVector hot_spots = network.hot_spots(temperatures);
  HottestSpot worst{.excess = -std::numeric_limits<double>::infinity(), .node = 0};
  for (std::size_t i = 0; i < network.nodes().size(); ++i) {
    if (network.nodes()[i].kind == NodeKind::silicone) continue;
    const double excess = hot_spots(static_cast<Eigen::Index>(i)) - network.nodes()[i].temperature_limit;
    if (excess > worst.excess) worst = {.excess = excess, .node = i};
  }
  return worst;
}

}  // namespace coilwright::thermal
