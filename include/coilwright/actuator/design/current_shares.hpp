#pragma once

#include <string>
#include <vector>

#include "coilwright/actuator/design/design.hpp"

namespace coilwright::actuator {

/// Share of the operating current that each coil of the layout carries, base to tip, -1 to 1:
/// CoilDesign::current_shares, and 1 for further coils.
[[nodiscard]] std::vector<double> current_shares(const Design& design);

/// Whether every coil carries the whole operating current, as coils on one driver do.
[[nodiscard]] bool has_one_current(const Design& design);

/// The largest magnitude among the shares; > 0 for a design that can be built.
[[nodiscard]] double largest_current_share(const Design& design);

/// The number, from 1, of the first share that belongs to no coil of the layout and is not 1; 0 if there is none. Such
/// a share has no effect and is probably a slip.
[[nodiscard]] int share_without_coil(const Design& design);

/// Throws std::invalid_argument if coils have currents of their own. `what` names the thing that drives all coils
/// alike, such as "a cell".
void require_one_current(const Design& design, const std::string& what);

}  // namespace coilwright::actuator
