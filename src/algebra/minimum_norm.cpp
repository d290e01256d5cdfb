#include "coilwright/algebra/minimum_norm.hpp"

#include <Eigen/QR>

namespace coilwright::algebra {

using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd minimum_norm(const MatrixXd& matrix, const VectorXd& right, std::optional<double> threshold) {
  // Eigen's decomposition reads the first pivot of a matrix that has none.
  if (matrix.size() == 0) return VectorXd::Zero(matrix.cols());
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> factors;
  if (threshold) factors.setThreshold(*threshold);
  factors.compute(matrix);
  return factors.solve(right);
}

MatrixXd minimum_norm_columns(const MatrixXd& matrix, const MatrixXd& right) {
  if (matrix.size() == 0) return MatrixXd::Zero(matrix.cols(), right.cols());
  return matrix.completeOrthogonalDecomposition().solve(right);
}

}  // namespace coilwright::algebra
