#include "measurement/compare/cross_validation.hpp"

#include <tbb/parallel_for.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace coilwright::measurement::compare {
namespace {

// The step from the fit to all runs to the fit without one of them.
Eigen::VectorXd step_without(const FittedHypothesis& fitted, std::size_t run) {
  const Eigen::MatrixXd others = fitted.fit.normal_matrix - fitted.fit.runs[run].normal_matrix;
  const Eigen::VectorXd scales = fitted.hypothesis.scales();
  const Eigen::MatrixXd scaled = scales.asDiagonal() * others * scales.asDiagonal();
  // With the gradient g of the run left out and the normal matrix N of the others, the optimum of the others is at
  // +N^-1 g, because at the common optimum all gradients add up to zero.
  const Eigen::VectorXd step =
      scaled.completeOrthogonalDecomposition().solve(scales.asDiagonal() * fitted.fit.runs[run].gradient);
  return scales.asDiagonal() * step.cwiseMax(-1.0).cwiseMin(1.0);
}

// Chi-square of a run at parameters on which it had no influence.
fit::Counted<double> held_out_chi_square(std::span<const replay::PreparedRun> runs, const FittedHypothesis& fitted,
                                         std::size_t run) {
  Eigen::VectorXd values = fitted.fit.values;
  if (values.size() > 0) values = fitted.hypothesis.clamped(values + step_without(fitted, run));
  const auto there =
      fit::evaluate_at({.hypothesis = &fitted.hypothesis, .runs = runs.subspan(run, 1), .start = std::move(values)});
  return {.value = there.value ? there.value->chi_square : std::numeric_limits<double>::infinity(),
          .simulated_runs = there.simulated_runs};
}

}  // namespace

fit::Counted<double> cross_validated_gain(std::span<const replay::PreparedRun> runs, const FittedHypothesis& without,
                                          const FittedHypothesis& with) {
  if (runs.size() < 2) return {.value = std::numeric_limits<double>::quiet_NaN()};
  std::vector<fit::Counted<double>> chi_square_with(runs.size());
  std::vector<fit::Counted<double>> chi_square_without(runs.size());
  tbb::parallel_for(std::size_t{0}, runs.size(), [&](std::size_t r) {
    chi_square_without[r] = held_out_chi_square(runs, without, r);
    chi_square_with[r] = held_out_chi_square(runs, with, r);
  });
  double fall = 0.0;
  double above_noise = 0.0;
  double values = 0.0;
  long simulated_runs = 0;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const auto noise = static_cast<double>(without.fit.runs[r].residuals.size());
    fall += chi_square_without[r].value - chi_square_with[r].value;
    above_noise += chi_square_without[r].value - noise;
    values += noise;
    simulated_runs += chi_square_with[r].simulated_runs + chi_square_without[r].simulated_runs;
  }
  // Of a model that nearly reaches the noise, what is above it may be less than nothing: its standard deviation is the
  // least that a share can be taken of.
  return {.value = fall / std::max(above_noise, std::sqrt(2.0 * values)), .simulated_runs = simulated_runs};
}

}  // namespace coilwright::measurement::compare
