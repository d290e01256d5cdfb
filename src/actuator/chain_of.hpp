#pragma once

#include <vector>

#include "coilwright/actuator/design/design.hpp"
#include "coilwright/actuator/design/segments.hpp"
#include "coilwright/mechanics/planar_chain.hpp"

namespace coilwright::actuator {

/// The chain of all segments but the base, which does not move.
[[nodiscard]] mechanics::PlanarChain chain_of(const Design& design, const std::vector<Segment>& segments);

}  // namespace coilwright::actuator
