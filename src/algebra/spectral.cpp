#include "coilwright/algebra/spectral.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

namespace coilwright::algebra {

using Eigen::MatrixXd;
using Eigen::VectorXd;

SymmetricModes symmetric_modes(const MatrixXd& matrix) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(matrix);
  return {.values = solver.eigenvalues(), .vectors = solver.eigenvectors()};
}

VectorXd singular_values(const MatrixXd& matrix) {
  return Eigen::JacobiSVD<MatrixXd>(matrix).singularValues();
}

}  // namespace coilwright::algebra
