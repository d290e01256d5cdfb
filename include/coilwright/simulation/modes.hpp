#pragma once

#include <vector>

#include "coilwright/actuator/model/model.hpp"

namespace coilwright::simulation {

/// One free motion of the chain, linearised about an equilibrium.
struct Mode {
  double natural_frequency{};  ///< |eigenvalue| / 2 pi, Hz; >= 0
  double damping_ratio{};      ///< -Re(eigenvalue) / |eigenvalue|; below 1 it oscillates, negative it grows
};

/// Modes of M x'' + B x' + K x = 0 at `angles` under constant `currents`, slowest first. A pair of complex eigenvalues
/// is one mode; the two real ones of an overdamped motion are two modes of damping ratio 1 with their own rates.
[[nodiscard]] std::vector<Mode> modes(const actuator::Model& model, const mechanics::JointVector& angles,
                                      const actuator::CoilCurrents& currents);

}  // namespace coilwright::simulation
