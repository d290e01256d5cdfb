#include "coilwright/algebra/least_squares.hpp"

#include <Eigen/QR>

namespace coilwright::algebra {

using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd least_squares(const MatrixXd& columns, const VectorXd& values) {
  return columns.householderQr().solve(values);
}

MatrixXd orthonormal(const MatrixXd& columns) {
  const Eigen::HouseholderQR<MatrixXd> factor(columns);
  return factor.householderQ() * MatrixXd::Identity(columns.rows(), columns.cols());
}

}  // namespace coilwright::algebra
