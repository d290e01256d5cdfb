#pragma once

#include <Eigen/Core>
#include <vector>

#include "coilwright/actuator/model/model.hpp"

namespace coilwright::simulation {

/// Small motions about an equilibrium: x' = A x over angles, rates, and those states of effects that come back by
/// themselves when displaced (a lag, a creep).
///
/// A state that does not (a share of friction, a bristle that stays bent) belongs to what sticks, which has no small
/// motions that are linear: it is left out, as if it were at its settled value for good. So are bodies beside the chain
/// (a mount, a loose magnet): these are the motions of the joints with all bodies at rest in their places.
struct LinearSystem {
  Eigen::MatrixXd matrix;              ///< (2n + relaxing, 2n + relaxing), 1/s between like units
  int relaxing{};                      ///< states of effects in it, the last ones
  bool sticks{};                       ///< whether any was left out: motions then need not end in the equilibrium
  std::vector<int> relaxing_states{};  ///< which of the model's states they are

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

/// How the slopes of the system's states change with the current of each coil, the states held: a matrix B with a
/// column for each coil, in the states' units a second and ampere. For models without bodies beside the chain.
[[nodiscard]] Eigen::MatrixXd slopes_by_currents(const actuator::Model& model, const mechanics::JointVector& angles,
                                                 const actuator::CoilCurrents& currents, const LinearSystem& system);

}  // namespace coilwright::simulation
