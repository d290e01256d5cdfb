#include "measurement/identification/discrepancy.hpp"

#include <boost/math/differentiation/finite_difference.hpp>
#include <cmath>
#include <numbers>

namespace coilwright::measurement::identification {

DiscrepancyFilter::DiscrepancyFilter(const Series& series, const Discrepancy& discrepancy) {
  const double rate = std::numbers::sqrt3 / discrepancy.length;
  const double variance = discrepancy.deviation * discrepancy.deviation;
  const double slope_variance = variance * rate * rate;
  // Covariance of level and slope before a sample is seen; at first that of the stationary process.
  double level = variance, cross = 0.0, slope = slope_variance;
  // Where samples are alike and evenly spaced the covariance soon stays the same, and so does the step.
  double last_level = -1.0, last_cross = 0.0, last_slope = 0.0, last_by = -1.0, last_logarithm = 0.0;
  const auto is_near = [](double a, double b) { return std::abs(a - b) <= 1e-14 * std::abs(b); };
  steps_.reserve(series.set_aside.size());
  for (Eigen::Index i = 0; i < series.samples(); ++i) {
    const bool is_seen = series.set_aside[static_cast<std::size_t>(i)] == 0;
    if (i > 0 && is_seen && series.steps[static_cast<std::size_t>(i - 1)] == last_by && is_near(level, last_level) &&
        is_near(cross, last_cross) && is_near(slope, last_slope)) {
      steps_.push_back(steps_.back());
      log_determinant_ += last_logarithm;
      continue;
    }
    last_level = level;
    last_cross = cross;
    last_slope = slope;
    last_by = -1.0;
    Step step{.level_of_level = 1.0, .slope_of_slope = 1.0};
    if (i > 0) {
      const double by = series.steps[static_cast<std::size_t>(i - 1)];
      const double decay = std::exp(-rate * by);
      step.level_of_level = decay * (1.0 + rate * by);
      step.level_of_slope = decay * by;
      step.slope_of_level = -decay * rate * rate * by;
      step.slope_of_slope = decay * (1.0 - rate * by);
      // What is known of the process beyond its stationary covariance decays; the rest comes back.
      const double a = level - variance, b = cross, c = slope - slope_variance;
      const double ll = step.level_of_level, ls = step.level_of_slope;
      const double sl = step.slope_of_level, ss = step.slope_of_slope;
      level = variance + ll * ll * a + 2.0 * ll * ls * b + ls * ls * c;
      cross = ll * sl * a + (ll * ss + ls * sl) * b + ls * ss * c;
      slope = slope_variance + sl * sl * a + 2.0 * sl * ss * b + ss * ss * c;
    }
    if (is_seen) {
      const double innovation = level + discrepancy.white;
      last_logarithm = std::log(innovation);
      log_determinant_ += last_logarithm;
      if (i > 0) last_by = series.steps[static_cast<std::size_t>(i - 1)];
      step.over_deviation = 1.0 / std::sqrt(innovation);
      step.gain_of_level = level / innovation;
      step.gain_of_slope = cross / innovation;
      slope -= step.gain_of_slope * cross;
      cross -= step.gain_of_level * cross;
      level -= step.gain_of_level * level;
    }
    steps_.push_back(step);
  }
}

void DiscrepancyFilter::whiten(
    Eigen::Ref<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>> rows) const {
  const auto columns = static_cast<std::size_t>(rows.cols());
  std::vector<double> level(columns, 0.0);
  std::vector<double> slope(columns, 0.0);
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    const Step& step = steps_[i];
    double* row = &rows(static_cast<Eigen::Index>(i), 0);
    for (std::size_t c = 0; c < columns; ++c) {
      const double expected = step.level_of_level * level[c] + step.level_of_slope * slope[c];
      const double leaving = step.slope_of_level * level[c] + step.slope_of_slope * slope[c];
      const double innovation = row[c] - expected;
      level[c] = expected + step.gain_of_level * innovation;
      slope[c] = leaving + step.gain_of_slope * innovation;
      row[c] = step.over_deviation * innovation;
    }
  }
}

// The slope of the logarithm of |K + W| over that of the variance.
double values_told(const Series& series, const Discrepancy& discrepancy) {
  if (discrepancy.deviation == 0.0) return 0.0;
  const auto log_determinant = [&](double log_variance) {
    Discrepancy other = discrepancy;
    other.deviation = std::exp(0.5 * log_variance);
    return DiscrepancyFilter(series, other).log_determinant();
  };
  return boost::math::differentiation::finite_difference_derivative(log_determinant,
                                                                    2.0 * std::log(discrepancy.deviation));
}

}  // namespace coilwright::measurement::identification
