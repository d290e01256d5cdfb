#pragma once

#include <vector>

#include "coilwright/mechanics/planar_chain.hpp"

namespace coilwright::actuator::effects {

/// The links of a chain, to build another one from.
[[nodiscard]] inline std::vector<mechanics::Link> links_of(const mechanics::PlanarChain& chain) {
  std::vector<mechanics::Link> links;
  for (int j = 0; j < chain.joints(); ++j) links.push_back(chain.link(j));
  return links;
}

}  // namespace coilwright::actuator::effects
