#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace coilwright::measurement::identification {

/// What a model still lacks: a stationary process beside the noise with a Matérn covariance of smoothness 3/2,
/// deviation^2 (1 + w) exp(-w), w = sqrt(3) steps / length. Continuous with its slope, as a motion is that a missing
/// torque makes (Kennedy and O'Hagan, J. R. Stat. Soc. B 63 (2001) 425).
struct Discrepancy {
  double deviation{};   ///< standard deviation, over that of the noise; 0: nothing is missing
  double length = 1.0;  ///< correlation length, in sampling intervals; > 0
  double white = 1.0;   ///< variance of the white noise beside it, over that of the noise; > 0
};

/// One channel of one window: samples that share a discrepancy.
struct Series {
  Eigen::Index first{};   ///< row of its first sample in the block of the window
  double interval = 1.0;  ///< between its samples, the median, in sampling intervals of the fastest run
  /// From each sample to the next, in sampling intervals of the fastest run: one less than samples.
  std::vector<double> steps{};
  std::vector<char> set_aside{};  ///< for each sample whether it counts as not measured
  /// Degrees of freedom of the noise's variance; infinite where it is known.
  double freedom{};
  /// How long noise may be correlated that has that variance, beyond what its record tells; 0: it is white.
  double longest_colour{};
  [[nodiscard]] Eigen::Index samples() const { return static_cast<Eigen::Index>(set_aside.size()); }
};

/// Makes a series of discrepancy and noise white: the innovations of a Kalman filter of two states, each over its
/// standard deviation, so that a likelihood costs as many steps as there are samples (Hartikainen and Särkkä, IEEE MLSP
/// 2010). Refers to the series.
class DiscrepancyFilter {
 public:
  DiscrepancyFilter(const Series& series, const Discrepancy& discrepancy);

  /// Each column of `rows` (samples, columns) becomes its innovations; those of samples set aside are 0.
  void whiten(Eigen::Ref<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>> rows) const;
  /// The logarithm of the determinant of the covariance of the samples that were measured.
  [[nodiscard]] double log_determinant() const noexcept { return log_determinant_; }

 private:
  struct Step {
    double level_of_level{}, level_of_slope{}, slope_of_level{}, slope_of_slope{};  // transition from the sample before
    double gain_of_level{}, gain_of_slope{};
    double over_deviation{};  // 1 over that of the innovation; 0 for a sample set aside
  };
  std::vector<Step> steps_;
  double log_determinant_{};
};

/// How many values of the discrepancy a series tells apart from noise: the trace of K (K + W)^-1, K its covariance and
/// W the white noise's. As many as there are samples where it is far above the noise, and few where it is below.
[[nodiscard]] double values_told(const Series& series, const Discrepancy& discrepancy);

}  // namespace coilwright::measurement::identification
