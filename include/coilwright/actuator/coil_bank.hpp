#pragma once

#include <Eigen/Core>
#include <vector>

#include "coilwright/actuator/assemble.hpp"
#include "coilwright/actuator/design/design.hpp"
#include "coilwright/drive/coil_bank.hpp"

namespace coilwright::actuator {

/// The coils of an assembled design as one driver sees them, base to tip, each at its mean temperature (degC). Mutual
/// inductances are those of the straight actuator, signed by the coils' polarities. Throws std::invalid_argument unless
/// each coil has a finite temperature at which copper's linear law holds.
[[nodiscard]] drive::CoilBank coil_bank(const Design& design, const Assembly& assembly, drive::BankWiring wiring,
                                        const Eigen::VectorXd& temperatures);

/// Indices of the coils in the layout, base to tip.
[[nodiscard]] std::vector<int> coil_places(const Layout& layout);

}  // namespace coilwright::actuator
