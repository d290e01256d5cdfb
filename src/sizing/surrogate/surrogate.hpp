#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <vector>

#include "sizing/nlopt/linearisation.hpp"

namespace coilwright::sizing {

/// A smooth model of several quantities through a set of nodes: the mean of a Gaussian process whose kernel is a full
/// quadratic plus a Matern-5/2 term. Where the nodes determine a quadratic, the model reproduces quadratics up to the
/// nugget; with fewer nodes linear terms come first, then squares, then products, and the Matern term follows the rest.
/// Hyperparameters are fixed in local coordinates, in which the box of the nodes is [-1, 1] along every axis and values
/// have mean 0 and range 1.
class Surrogate {
 public:
  /// `nodes`: (k, n), k >= 1; `values`: (k, outputs). `weights` (n, or empty for equal ones) say along which axes the
  /// Matern term may bend more: squared distances count so much.
  Surrogate(const Eigen::MatrixXd& nodes, const Eigen::MatrixXd& values, const std::vector<double>& weights = {});

  /// Values at `x` (n): (outputs).
  [[nodiscard]] Eigen::VectorXd values(const Eigen::VectorXd& x) const;

  /// What the process expects at several places.
  struct Prediction {
    Eigen::MatrixXd means;       ///< (places, outputs)
    Eigen::MatrixXd covariance;  ///< (places, places), of an output of variance 1
    Eigen::VectorXd deviations;  ///< (outputs): the most likely standard deviation, by which `covariance` is scaled
  };
  /// The process at the columns of `places` (n, places).
  [[nodiscard]] Prediction predicted(const Eigen::MatrixXd& places) const;

  /// Values and gradients at `x` (n).
  [[nodiscard]] Linearisation linearised(const Eigen::VectorXd& x) const;

 private:
  [[nodiscard]] Eigen::VectorXd local(const Eigen::VectorXd& x) const;
  [[nodiscard]] Eigen::MatrixXd kernel(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) const;
  [[nodiscard]] double squared_distance(Eigen::Index node, const Eigen::VectorXd& at) const;
  [[nodiscard]] double quadratic_kernel(double product, double squares) const;

  Eigen::VectorXd centre_, half_width_;
  Eigen::MatrixXd nodes_;    // (n, k), local
  Eigen::MatrixXd squares_;  // of the nodes' coordinates
  Eigen::LLT<Eigen::MatrixXd> factor_;
  Eigen::MatrixXd weights_;  // (k, outputs)
  Eigen::VectorXd deviation_;
  Eigen::VectorXd mean_, range_;
  Eigen::VectorXd stretch_;  // of squared distances along each axis, mean 1
  double length_;
  double linear_ = 1, square_ = 1,
         cross_ = 1;  // prior variances of coefficients, relative
};

}  // namespace coilwright::sizing
