#pragma once

#include <Eigen/Core>

#include "sizing/nlopt/linearisation.hpp"

namespace coilwright::sizing {

/// A smooth model of several quantities through a set of nodes: the mean of a Gaussian process whose kernel is a full
/// quadratic plus a Matern-5/2 term. Where the nodes determine a quadratic, the model reproduces quadratics up to the
/// nugget; with fewer nodes it takes the quadratic of least norm, and the Matern term follows the rest. Hyperparameters
/// are fixed in local coordinates, in which the box of the nodes is [-1, 1] along every axis and values have mean 0 and
/// range 1.
class Surrogate {
 public:
  /// `nodes`: (k, n), k >= 1; `values`: (k, outputs).
  Surrogate(const Eigen::MatrixXd& nodes, const Eigen::MatrixXd& values);

  /// Values at `x` (n): (outputs).
  [[nodiscard]] Eigen::VectorXd values(const Eigen::VectorXd& x) const;

  /// Values and gradients at `x` (n).
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
