#include "coilwright/algebra/exponential.hpp"

#include <cmath>

namespace coilwright::algebra {

using Eigen::MatrixXd;

HeldResponse held_response(const MatrixXd& matrix, double duration) {
  constexpr double longest = 0.25;    // of a fraction, over the norm of the matrix
  constexpr double smallest = 1e-16;  // term of the series
  const double size = duration * matrix.cwiseAbs().colwise().sum().maxCoeff();
  const int doublings = size > longest ? static_cast<int>(std::ceil(std::log2(size / longest))) : 0;
  const double part = std::ldexp(duration, -doublings);
  const Eigen::Index n = matrix.rows();
  // part (I + part A / 2 + part^2 A^2 / 6 + ..): products of few rows are quicker without packing.
  MatrixXd term = MatrixXd::Identity(n, n);
  MatrixXd sum = term;
  MatrixXd next(n, n);
  for (double k = 2.0; term.cwiseAbs().maxCoeff() > smallest; k += 1.0) {
    next.noalias() = (part / k) * matrix.lazyProduct(term);
    term.swap(next);
    sum += term;
  }
  HeldResponse out{.transition = MatrixXd::Identity(n, n), .integral = part * sum};
  out.transition += matrix.lazyProduct(out.integral);
  for (int i = 0; i < doublings; ++i) {
    next.noalias() = out.transition.lazyProduct(out.integral);
    out.integral += next;
    next.noalias() = out.transition.lazyProduct(out.transition);
    out.transition.swap(next);
  }
  return out;
}

}  // namespace coilwright::algebra
