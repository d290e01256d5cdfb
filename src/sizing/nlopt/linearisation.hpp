#pragma once

#include <Eigen/Core>

namespace coilwright::sizing {

/// Values of several functions at one point, and their gradients there.
struct Linearisation {
  Eigen::VectorXd values;    ///< (outputs)
  Eigen::MatrixXd jacobian;  ///< (outputs, n); empty where only values were asked for
};

}  // namespace coilwright::sizing
