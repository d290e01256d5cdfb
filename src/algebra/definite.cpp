#include "coilwright/algebra/definite.hpp"

#include <Eigen/Cholesky>

namespace coilwright::algebra {

using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd solve_definite(const MatrixXd& matrix, const VectorXd& right) {
  return matrix.llt().solve(right);
}

MatrixXd inverse_of_definite(const MatrixXd& matrix) {
  return matrix.llt().solve(MatrixXd::Identity(matrix.rows(), matrix.cols()));
}

}  // namespace coilwright::algebra
