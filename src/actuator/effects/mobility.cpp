#include "mobility.hpp"

#include <Eigen/Cholesky>

namespace coilwright::actuator::effects {

mechanics::JointVector joint_mobility(const mechanics::PlanarChain& chain) {
  const int n = chain.joints();
  return chain.mass_matrix(mechanics::JointVector::Zero(n))
      .llt()
      .solve(mechanics::JointMatrix::Identity(n, n))
      .diagonal();
}

}  // namespace coilwright::actuator::effects
