#include "measurement/identification/discrepancy.hpp"

#include <cmath>
#include <numbers>

namespace coilwright::measurement::identification {

DiscrepancyFilter::DiscrepancyFilter(const Series& series, const Discrepancy& discrepancy) {
  const double rate = std::numbers::sqrt3 / discrepancy.length;
  const double variance = discrepancy.deviation * discrepancy.deviation;
  const double slope_variance = variance * rate * rate;
  // Covariance of level and slope before a sample is seen; at first that of the stationary process.
  double level = variance, cross = 0.0, slope = slope_variance;
  for (Eigen::Index i = 0; i < series.samples(); ++i) {
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
    if (series.set_aside[static_cast<std::size_t>(i)] == 0) {
      const double innovation = level + 1.0;
      log_determinant_ += std::log(innovation);
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
  Eigen::Array<double, 1, Eigen::Dynamic> level = Eigen::Array<double, 1, Eigen::Dynamic>::Zero(rows.cols());
  Eigen::Array<double, 1, Eigen::Dynamic> slope = level;
  Eigen::Array<double, 1, Eigen::Dynamic> before = level;
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    const Step& step = steps_[i];
    auto row = rows.row(static_cast<Eigen::Index>(i)).array();
    before = level;
    level = step.level_of_level * before + step.level_of_slope * slope;
    slope = step.slope_of_level * before + step.slope_of_slope * slope;
    row -= level;
    level += step.gain_of_level * row;
    slope += step.gain_of_slope * row;
    row *= step.over_deviation;
  }
}

}  // namespace coilwright::measurement::identification
