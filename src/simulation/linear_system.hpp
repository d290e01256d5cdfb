#pragma once

#include <Eigen/Core>

#include "coilwright/actuator/model/model.hpp"

namespace coilwright::simulation {

/// Small motions about an equilibrium: x' = A x over angles, rates, and those states of effects that come back by
/// themselves when displaced (a lag, a creep).
///
/// A state that does not (a bristle at rest stays bent) belongs to friction, which has no small motions that are
/// linear: it is left out, as if it were at its settled value for good.
struct LinearSystem {
  Eigen::MatrixXd matrix;  ///< (2n + relaxing, 2n + relaxing), 1/s between like units
  int relaxing{};          ///< states of effects in it, the last ones
  bool sticks{};           ///< whether any was left out: motions then need not end in the equilibrium

  /// Of the matrix, 1/s.
  [[nodiscard]] Eigen::VectorXcd eigenvalues() const;
};

/// `angles` (rad) in equilibrium under `currents` (A).
[[nodiscard]] LinearSystem linear_system(const actuator::Model& model, const mechanics::JointVector& angles,
                                         const actuator::CoilCurrents& currents);

}  // namespace coilwright::simulation
