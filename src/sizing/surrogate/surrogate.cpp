#include "sizing/surrogate/surrogate.hpp"

#include <Eigen/Cholesky>
#include <cmath>

namespace coilwright::sizing {
namespace {

// Prior variance of the quadratic relative to that of the Matern term. Large, so that the quadratic explains what it
// can.
constexpr double quadratic_weight = 1000.0;
// Prior variance of the coefficients where there are fewer nodes than a quadratic has: the trend takes what it can,
// then the squares, and the bounded Matern term the rest. With equal weights the many products of two coordinates fit a
// straight line too, and beyond the nodes such a model falls off by many times the range of the values.
constexpr double undetermined_linear = 100;
constexpr double undetermined_square = 0.003;
constexpr double undetermined_cross = 1e-4;
// Matern length in units of the box's half diagonal.
constexpr double relative_length = 1.0;
// Relative to the largest diagonal entry: keeps the matrix positive definite for nodes that nearly coincide (rounding
// is 1e-16 and grows with the number of nodes), and bounds the interpolation error to about 1e-6 of the values' range.
constexpr double nugget = 1e-11;

struct Matern {
  double value, slope_over_distance;
};

Matern matern(double squared_distance, double length) {
  const double scaled = std::sqrt(5.0 * squared_distance) / length;
  const double decay = std::exp(-scaled);
  return {.value = (1 + scaled + scaled * scaled / 3) * decay,
          .slope_over_distance = -5.0 / (3 * length * length) * (1 + scaled) * decay};
}

}  // namespace

Surrogate::Surrogate(const Eigen::MatrixXd& nodes, const Eigen::MatrixXd& values, const std::vector<double>& weights)
    : length_{relative_length * std::sqrt(static_cast<double>(nodes.cols()))} {
  const Eigen::VectorXd low = nodes.colwise().minCoeff().transpose(), high = nodes.colwise().maxCoeff().transpose();
  centre_ = 0.5 * (low + high);
  half_width_ = 0.5 * (high - low);
  // An axis the nodes do not vary in has no scale of its own: it takes that of the widest one.
  const double widest = half_width_.size() > 0 ? half_width_.maxCoeff() : 1.0;
  half_width_ = half_width_.cwiseMax(widest > 0 ? 0.05 * widest : 1.0);
  nodes_ = ((nodes.rowwise() - centre_.transpose()).array().rowwise() / half_width_.transpose().array())
               .matrix()
               .transpose();
  stretch_ = Eigen::VectorXd::Ones(nodes_.rows());
  if (!weights.empty()) {
    const Eigen::Map<const Eigen::VectorXd> given(weights.data(), nodes_.rows());
    stretch_ = given * (static_cast<double>(nodes_.rows()) / given.sum());
  }
  mean_ = values.colwise().mean().transpose();
  range_ = (values.colwise().maxCoeff() - values.colwise().minCoeff()).transpose();
  range_ = (range_.array() > 0).select(range_, 1.0);

  const Eigen::Index count = nodes_.cols();
  const Eigen::Index n = nodes_.rows();
  if (count < (n + 1) * (n + 2) / 2) {
    linear_ = undetermined_linear;
    square_ = undetermined_square;
    cross_ = undetermined_cross;
  }
  squares_ = nodes_.cwiseAbs2();
  Eigen::MatrixXd between = kernel(nodes_, nodes_);
  between.diagonal().array() += nugget * between.diagonal().maxCoeff();
  factor_.compute(between);
  const Eigen::MatrixXd scaled =
      ((values.rowwise() - mean_.transpose()).array().rowwise() / range_.transpose().array()).matrix();
  weights_ = factor_.solve(scaled);
  deviation_ =
      (scaled.cwiseProduct(weights_).colwise().mean().transpose().cwiseMax(0.0).cwiseSqrt()).cwiseProduct(range_);
}

// Between the columns of two matrices of places in local coordinates; of one matrix with itself the lower half.
Eigen::MatrixXd Surrogate::kernel(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) const {
  const bool one = &a == &b;
  const Eigen::MatrixXd products = a.transpose() * b, stretched = a.transpose() * stretch_.asDiagonal() * b;
  const Eigen::MatrixXd squares_a = a.cwiseAbs2(), squares_b = b.cwiseAbs2();
  const Eigen::MatrixXd square_products = squares_a.transpose() * squares_b;
  const Eigen::VectorXd lengths_a = one ? Eigen::VectorXd{stretched.diagonal()} : squares_a.transpose() * stretch_;
  const Eigen::VectorXd lengths_b = one ? lengths_a : squares_b.transpose() * stretch_;
  Eigen::MatrixXd result(a.cols(), b.cols());
  for (Eigen::Index j = 0; j < b.cols(); ++j) {
    for (Eigen::Index i = one ? j : 0; i < a.cols(); ++i) {
      const double squared = std::max(0.0, lengths_a[i] + lengths_b[j] - 2 * stretched(i, j));
      const double quadratic = quadratic_kernel(products(i, j), square_products(i, j));
      result(i, j) = quadratic_weight * quadratic + matern(squared, length_).value;
    }
  }
  return result;
}

double Surrogate::squared_distance(Eigen::Index node, const Eigen::VectorXd& at) const {
  return ((nodes_.col(node) - at).cwiseAbs2().cwiseProduct(stretch_)).sum();
}

double Surrogate::quadratic_kernel(double product, double squares) const {
  return 1 + 2 * linear_ * product + cross_ * product * product + (square_ - cross_) * squares;
}

Eigen::VectorXd Surrogate::local(const Eigen::VectorXd& x) const {
  return (x - centre_).cwiseQuotient(half_width_);
}

Eigen::VectorXd Surrogate::values(const Eigen::VectorXd& x) const {
  const Eigen::VectorXd at = local(x);
  Eigen::VectorXd kernel(nodes_.cols());
  const Eigen::VectorXd square = at.cwiseAbs2();
  for (Eigen::Index i = 0; i < nodes_.cols(); ++i) {
    kernel[i] = quadratic_weight * quadratic_kernel(nodes_.col(i).dot(at), squares_.col(i).dot(square)) +
                matern(squared_distance(i, at), length_).value;
  }
  return mean_ + range_.cwiseProduct(weights_.transpose() * kernel);
}

Surrogate::Prediction Surrogate::predicted(const Eigen::MatrixXd& places) const {
  const Eigen::MatrixXd at = (places.colwise() - centre_).array().colwise() / half_width_.array();
  const Eigen::MatrixXd to_nodes = kernel(nodes_, at), explained = factor_.matrixL().solve(to_nodes);
  Eigen::MatrixXd means = (to_nodes.transpose() * weights_) * range_.asDiagonal();
  means.rowwise() += mean_.transpose();
  Eigen::MatrixXd covariance = kernel(at, at).selfadjointView<Eigen::Lower>();
  covariance -= explained.transpose() * explained;
  return {.means = std::move(means), .covariance = std::move(covariance), .deviations = deviation_};
}

Linearisation Surrogate::linearised(const Eigen::VectorXd& x) const {
  const Eigen::VectorXd at = local(x);
  const Eigen::Index count = nodes_.cols();
  Eigen::VectorXd kernel(count), along_node(count), along_x(count);
  const Eigen::VectorXd square = at.cwiseAbs2();
  for (Eigen::Index i = 0; i < count; ++i) {
    const double product = nodes_.col(i).dot(at);
    const Matern term = matern(squared_distance(i, at), length_);
    kernel[i] = quadratic_weight * quadratic_kernel(product, squares_.col(i).dot(square)) + term.value;
    along_node[i] = 2 * quadratic_weight * (linear_ + cross_ * product);
    along_x[i] = term.slope_over_distance;
  }
  // d kernel_i / d at = along_node_i * node_i + along_x_i * stretch * (at - node_i)
  Eigen::MatrixXd slope = weights_.transpose() * along_node.asDiagonal() * nodes_.transpose();
  Eigen::MatrixXd bend = (weights_.transpose() * along_x) * at.transpose();
  bend.noalias() -= weights_.transpose() * along_x.asDiagonal() * nodes_.transpose();
  slope.noalias() += bend * stretch_.asDiagonal();
  if (square_ != cross_) {
    slope.array() += (2 * quadratic_weight * (square_ - cross_)) *
                     ((weights_.transpose() * squares_.transpose()).array().rowwise() * at.transpose().array());
  }
  slope = range_.asDiagonal() * slope * half_width_.cwiseInverse().asDiagonal();
  return {.values = mean_ + range_.cwiseProduct(weights_.transpose() * kernel), .jacobian = std::move(slope)};
}

}  // namespace coilwright::sizing
