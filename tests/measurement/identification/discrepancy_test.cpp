#include "measurement/identification/discrepancy.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace coilwright::measurement::identification {
namespace {

using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// Uneven sampling, two samples set aside.
Series uneven_series() {
  Series out{.freedom = std::numeric_limits<double>::infinity()};
  out.set_aside.assign(12, 0);
  out.set_aside[3] = out.set_aside[7] = 1;
  out.steps = {1.0, 1.0, 0.9, 1.1, 3.0, 1.0, 1.0, 0.2, 1.0, 1.0, 5.0};
  return out;
}

// The covariance of what was measured, written out; `kept` are its samples.
Eigen::MatrixXd covariance_of(const Series& series, const Discrepancy& d, std::vector<Eigen::Index>& kept) {
  std::vector<double> at{0.0};
  for (const double step : series.steps) at.push_back(at.back() + step);
  for (Eigen::Index i = 0; i < series.samples(); ++i)
    if (series.set_aside[static_cast<std::size_t>(i)] == 0) kept.push_back(i);
  const auto n = static_cast<Eigen::Index>(kept.size());
  Eigen::MatrixXd out = Eigen::MatrixXd::Identity(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index k = 0; k < n; ++k) {
      const double w = std::sqrt(3.0) / d.length *
                       std::abs(at[static_cast<std::size_t>(kept[static_cast<std::size_t>(i)])] -
                                at[static_cast<std::size_t>(kept[static_cast<std::size_t>(k)])]);
      out(i, k) += d.deviation * d.deviation * (1.0 + w) * std::exp(-w);
    }
  return out;
}

// So many even samples that the filter's gains come to rest, twice: a sample is set aside, and a step is long.
Series even_series() {
  Series out{.freedom = std::numeric_limits<double>::infinity()};
  out.set_aside.assign(400, 0);
  out.set_aside[150] = 1;
  out.steps.assign(399, 1.0);
  out.steps[250] = 2.0;
  return out;
}

class DiscrepancyFilterOf : public testing::TestWithParam<Series> {};

TEST_P(DiscrepancyFilterOf, GivesTheGaussianLikelihoodOfTheWholeCovariance) {
  const Series& series = GetParam();
  for (const Discrepancy& d : {Discrepancy{.deviation = 0.3, .length = 2.0}, {.deviation = 5.0, .length = 8.0}}) {
    Rows rows(series.samples(), 2);
    for (Eigen::Index i = 0; i < rows.rows(); ++i)
      rows.row(i) << std::sin(1.3 * static_cast<double>(i)), std::cos(0.4 * static_cast<double>(i * i));
    std::vector<Eigen::Index> kept;
    const Eigen::LLT<Eigen::MatrixXd> whole(covariance_of(series, d, kept));
    const Eigen::MatrixXd measured = rows(kept, Eigen::all);
    const Eigen::MatrixXd expected = measured.transpose() * whole.solve(measured);

    const DiscrepancyFilter filter(series, d);
    filter.whiten(rows);
    EXPECT_TRUE((rows.transpose() * rows).isApprox(expected, 1e-12));
    EXPECT_NEAR(filter.log_determinant(), 2.0 * whole.matrixLLT().diagonal().array().log().sum(), 1e-10);
  }
}

TEST_P(DiscrepancyFilterOf, CountsWhatIsToldApartFromNoise) {
  const Series& series = GetParam();
  for (const double deviation : {0.02, 0.3, 5.0, 1e4}) {
    const Discrepancy d{.deviation = deviation, .length = 8.0};
    std::vector<Eigen::Index> kept;
    const Eigen::MatrixXd whole = covariance_of(series, d, kept);
    const double expected = static_cast<double>(kept.size()) - whole.inverse().trace();
    EXPECT_NEAR(values_told(series, d), expected, 1e-10 * static_cast<double>(kept.size()));
  }
  EXPECT_EQ(values_told(series, {.deviation = 0.0, .length = 8.0}), 0.0);
}

INSTANTIATE_TEST_SUITE_P(Series, DiscrepancyFilterOf, testing::Values(uneven_series(), even_series()));

TEST(DiscrepancyFilter, OfNothingMissingChangesNothing) {
  const Series series = uneven_series();
  const DiscrepancyFilter filter(series, {.deviation = 0.0, .length = 4.0});
  Rows rows = Rows::Constant(series.samples(), 1, 2.0);
  filter.whiten(rows);
  EXPECT_EQ(rows(0, 0), 2.0);
  EXPECT_EQ(rows(3, 0), 0.0);  // set aside
  EXPECT_EQ(filter.log_determinant(), 0.0);
}

}  // namespace
}  // namespace coilwright::measurement::identification
