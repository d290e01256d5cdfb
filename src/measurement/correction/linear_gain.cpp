#include "measurement/correction/linear_gain.hpp"

#include <array>
#include <limits>

#include "coilwright/algebra/definite.hpp"

namespace coilwright::measurement::correction {
namespace {

// Standard deviations of the coefficients that are compared, from torques far below what is left over to far above.
constexpr std::array deviations = {0.03, 0.1, 0.3, 1.0, 3.0};
// No number moves further than some ten of its typical changes, whatever the data say of it.
constexpr double loosest = 0.01;

// Least squares of the linearised residuals, in units of typical changes.
class Linearised {
 public:
  Linearised(const fit::Hypothesis& hypothesis, const fit::Fit& at_zero, int coefficients)
      : fit_(at_zero), scales_(hypothesis.scales()), free_(hypothesis.size() - coefficients) {
    prior_ = Eigen::VectorXd::Constant(hypothesis.size(), loosest);
    prior_gradient_ = Eigen::VectorXd::Zero(hypothesis.size());
    for (Eigen::Index i = 0; i < free_; ++i) {
      const fit::FitParameter& parameter = hypothesis.parameters()[static_cast<std::size_t>(i)];
      if (!parameter.is_pulled(at_zero.values[i])) continue;
      const double size = at_zero.model_error * scales_[i] / parameter.tolerance;
      prior_[i] += size * size;
      prior_gradient_[i] = size * at_zero.model_error * (at_zero.values[i] - parameter.declared) / parameter.tolerance;
    }
  }

  // The step in units of typical changes with one run left out (or none, with a run beyond the last), of the first
  // `count` numbers.
  [[nodiscard]] Eigen::VectorXd step(std::size_t without, double deviation, Eigen::Index count) const {
    const Eigen::Index n = scales_.size();
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(n, n);
    Eigen::VectorXd gradient = prior_gradient_;
    for (std::size_t r = 0; r < fit_.runs.size(); ++r) {
      if (r == without) continue;
      normal += fit_.runs[r].normal_matrix;
      gradient += scales_.cwiseProduct(fit_.runs[r].gradient);
    }
    normal = (scales_.asDiagonal() * normal * scales_.asDiagonal()).eval();
    normal.diagonal() += prior_;
    normal.diagonal().tail(n - free_).array() += scales_.tail(n - free_).array().square() / (deviation * deviation);
    Eigen::VectorXd out = Eigen::VectorXd::Zero(n);
    out.head(count) = -algebra::solve_definite(normal.topLeftCorner(count, count), gradient.head(count));
    return out;
  }

  // The squared residual of a run after a step, less what it is now.
  [[nodiscard]] double change(std::size_t run, const Eigen::VectorXd& step) const {
    const Eigen::VectorXd moved = scales_.cwiseProduct(step);
    return moved.dot(2.0 * fit_.runs[run].gradient + fit_.runs[run].normal_matrix * moved);
  }

  [[nodiscard]] double change_of_runs_left_out(double deviation, Eigen::Index count) const {
    double sum = 0.0;
    for (std::size_t r = 0; r < fit_.runs.size(); ++r) sum += change(r, step(r, deviation, count));
    return sum;
  }

  [[nodiscard]] Eigen::Index free() const { return free_; }
  [[nodiscard]] Eigen::Index size() const { return scales_.size(); }
  [[nodiscard]] const Eigen::VectorXd& scales() const { return scales_; }

 private:
  const fit::Fit& fit_;
  Eigen::VectorXd scales_;
  Eigen::Index free_;  // all numbers but the coefficients
  Eigen::VectorXd prior_, prior_gradient_;
};

}  // namespace

LinearGain linear_gain(const fit::Hypothesis& hypothesis, const fit::Fit& at_zero, int coefficients) {
  const Linearised linearised(hypothesis, at_zero, coefficients);
  const double without = linearised.change_of_runs_left_out(1.0, linearised.free());
  LinearGain best{.fall = -std::numeric_limits<double>::infinity()};
  for (const double deviation : deviations) {
    const double fall = without - linearised.change_of_runs_left_out(deviation, linearised.size());
    if (fall <= best.fall) continue;
    best.fall = fall;
    best.deviation = deviation;
  }
  if (best.deviation > 0.0)
    best.step =
        linearised.scales().cwiseProduct(linearised.step(at_zero.runs.size(), best.deviation, linearised.size()));
  return best;
}

}  // namespace coilwright::measurement::correction
