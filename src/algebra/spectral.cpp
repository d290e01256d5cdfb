#include "coilwright/algebra/spectral.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

namespace coilwright::algebra {

using Eigen::MatrixXd;
using Eigen::VectorXd;

SymmetricModes symmetric_modes(const MatrixXd& matrix) {
  if (matrix.size() == 0) return {};  // Eigen's solver reads its first element
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(matrix);
  return {.values = solver.eigenvalues(), .vectors = solver.eigenvectors()};
}

VectorXd singular_values(const MatrixXd& matrix) {
  if (matrix.size() == 0) return {};
  return Eigen::JacobiSVD<MatrixXd>(matrix).singularValues();
}

}  // namespace coilwright::algebra
