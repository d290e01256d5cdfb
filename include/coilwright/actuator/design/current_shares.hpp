#pragma once

#include <string>
#include <vector>

#include "coilwright/actuator/design/design.hpp"

namespace coilwright::actuator {

/// What each coil of the layout carries of the operating current, base to tip, -1 to 1: CoilDesign::current_shares, and
/// 1 for coils beyond those.
[[nodiscard]] std::vector<double> current_shares(const Design& design);

/// Whether every coil carries the whole operating current, as coils on one driver do.
[[nodiscard]] bool has_one_current(const Design& design);

/// The largest magnitude among them; > 0 for a design that can be built.
[[nodiscard]] double largest_current_share(const Design& design);

/// The first share of a coil that the layout does not have and that is not 1, counted from 1; 0 where there is none.
/// Such a share does nothing, and is likely a slip.
[[nodiscard]] int share_without_coil(const Design& design);

/// Throws std::invalid_argument where coils have currents of their own: `what` drives all alike, "a cell" say.
void require_one_current(const Design& design, const std::string& what);

}  // namespace coilwright::actuator
