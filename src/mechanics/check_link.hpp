#pragma once

#include "coilwright/mechanics/planar_chain.hpp"

namespace coilwright::mechanics {

/// Throws std::invalid_argument naming link, field, rule and value if the link number `index` of a chain breaks a rule
/// of Link.
void check_link(const Link& link, int index);

}  // namespace coilwright::mechanics
