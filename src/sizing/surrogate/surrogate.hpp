#pragma once

#include <Eigen/Core>

namespace coilwright::sizing {

/// A smooth model of several quantities through a set of nodes: a Gaussian process mean whose kernel is a full
/// quadratic plus a Matern-5/2 term. Exact (to the nugget) on quadratics once the nodes determine one, the quadratic of
/// least norm before, with the Matern term for what a quadratic cannot follow. Fixed hyperparameters in local
/// coordinates: the box of the nodes becomes [-1, 1] in every axis, values become mean 0 and range 1.
class Surrogate {
 public:
  /// `nodes`: (k, n), k >= 1; `values`: (k, outputs).
  Surrogate(const Eigen::MatrixXd& nodes, const Eigen::MatrixXd& values);

  /// Values at `x` (n): (outputs).
  [[nodiscard]] Eigen::VectorXd values(const Eigen::VectorXd& x) const;

  /// Values and their gradients.
  struct Linearisation {
    Eigen::VectorXd values;    ///< (outputs)
    Eigen::MatrixXd jacobian;  ///< (outputs, n)
  };
  [[nodiscard]] Linearisation linearised(const Eigen::VectorXd& x) const;

 private:
  [[nodiscard]] Eigen::VectorXd local(const Eigen::VectorXd& x) const;

  Eigen::VectorXd centre_, half_width_;
  Eigen::MatrixXd nodes_;    // (n, k), local
  Eigen::MatrixXd weights_;  // (k, outputs)
  Eigen::VectorXd mean_, range_;
  double length_;
};

}  // namespace coilwright::sizing
