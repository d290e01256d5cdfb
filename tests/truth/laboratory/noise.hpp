#pragma once

#include <Eigen/Core>
#include <vector>

#include "truth/laboratory/request.hpp"
#include "truth/random.hpp"

namespace truth::laboratory {

/// Noise of the camera in one channel, with unit variance at any time:
/// white; low-passed: a filter of the first order with 10 Hz, and nothing above; pink: a sum of eight such filters with
/// corners from 0.03 to 100 Hz, equal variances, a spectrum near 1/f in between; hum: half of the variance in a line of
/// 50 Hz, whose frequency pictures alias, half white.
class Noise {
 public:
  Noise(Colour colour, Random& random);

  /// The values at increasing times, s.
  [[nodiscard]] std::vector<double> at(const std::vector<double>& times);

 private:
  Colour colour_;
  Random& random_;
};

/// The covariance of that noise at two times so far apart, s; 1 at 0.
[[nodiscard]] double covariance(Colour colour, double apart);

/// `change` of readings at increasing times, in standard deviations of a reading, as what it is worth beside this noise
/// and `white` variance more (of rounding): its norm is the number of standard deviations by which noise would have to
/// differ to look alike (by Cholesky's factor of the covariance). Stretches of 1500 readings are taken as independent,
/// which is exact for white noise.
[[nodiscard]] Eigen::VectorXd over_noise(Colour colour, double white, const std::vector<double>& times,
                                         const Eigen::VectorXd& change);

}  // namespace truth::laboratory
