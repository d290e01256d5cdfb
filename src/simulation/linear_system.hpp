#pragma once

#include <Eigen/Core>

#include "coilwright/actuator/model/model.hpp"

namespace coilwright::simulation {

/// Small motions about an equilibrium: x' = A x over angles, rates, and those states of effects that come back by
/// themselves when displaced (a lag, a creep).
///
/// A state that does not (a bristle at rest stays bent) belongs to friction, which has no small motions that are
/// linear: it is left out, as if it were at its settled value for good. So are bodies beside the chain (a mount, a
/// loose magnet): these are the motions of the joints with all bodies at rest in their places.
struct LinearSystem {
  Eigen::MatrixXd matrix;  ///< (2n + relaxing, 2n + relaxing), 1/s between like units
  int relaxing{};          ///< states of effects in it, the last ones
  bool sticks{};           ///< whether any was left out: motions then need not end in the equilibrium

  /// Eigenvalues, 1/s; of each, a column of `right` and a row of `left`, which is the inverse of `right`.
  struct Decomposition {
    Eigen::VectorXcd values;
    Eigen::MatrixXcd right, left;
  };

  /// Of the matrix, 1/s. Everything that needs them asks here: compiling Eigen's solver takes ten seconds.
  [[nodiscard]] Eigen::VectorXcd eigenvalues() const;
  [[nodiscard]] Decomposition decomposition() const;
};

/// `angles` (rad) in equilibrium under `currents` (A).
[[nodiscard]] LinearSystem linear_system(const actuator::Model& model, const mechanics::JointVector& angles,
                                         const actuator::CoilCurrents& currents);

}  // namespace coilwright::simulation
