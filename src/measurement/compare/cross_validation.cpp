#include "measurement/compare/cross_validation.hpp"

#include <tbb/parallel_for.h>

#include <Eigen/QR>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace coilwright::measurement::compare {
namespace {

// From the fit to all runs to the fit without one of them.
Eigen::VectorXd step_without(const Scored& s, std::size_t run) {
  const Eigen::MatrixXd others = s.fit.normal - s.fit.runs[run].normal;
  const Eigen::VectorXd scales = s.hypothesis.scales();
  const Eigen::MatrixXd scaled = scales.asDiagonal() * others * scales.asDiagonal();
  // Residuals r with slope dr/dx: the others' optimum lies at +N^-1 g of the run left out, for at the common optimum
  // all slopes add up to nothing.
  const Eigen::VectorXd step =
      scaled.completeOrthogonalDecomposition().solve(scales.asDiagonal() * s.fit.runs[run].slope);
  return scales.asDiagonal() * step.cwiseMax(-1.0).cwiseMin(1.0);
}

// Chi^2 of a run at values that it had no part in.
double held_out_chi_square(std::span<const replay::Record> records, const Scored& s, std::size_t run) {
  Eigen::VectorXd values = s.fit.values;
  if (values.size() > 0) values = s.hypothesis.clamped(values + step_without(s, run));
  const auto there =
      fit::evaluate_at({.hypothesis = &s.hypothesis, .records = records.subspan(run, 1), .start = std::move(values)});
  return there ? there->chi_square : std::numeric_limits<double>::infinity();
}

}  // namespace

double cross_validated_gain(std::span<const replay::Record> records, const Scored& a, const Scored& b) {
  if (records.size() < 2) return std::numeric_limits<double>::quiet_NaN();
  std::vector<double> with(records.size());
  std::vector<double> without(records.size());
  tbb::parallel_for(std::size_t{0}, records.size(), [&](std::size_t r) {
    without[r] = held_out_chi_square(records, a, r);
    with[r] = held_out_chi_square(records, b, r);
  });
  double excess_with = 0.0;
  double excess_without = 0.0;
  for (std::size_t r = 0; r < records.size(); ++r) {
    const auto noise = static_cast<double>(a.fit.runs[r].residuals.size());
    excess_with += with[r] - noise;
    excess_without += without[r] - noise;
  }
  return 1.0 - excess_with / excess_without;
}

}  // namespace coilwright::measurement::compare
