#pragma once

#include <Eigen/Core>
#include <vector>

#include "measurement/signals/noise_colour.hpp"

namespace coilwright::measurement::signals {

/// Turns stationary coloured noise into white noise of unit variance: the error of the best linear prediction of each
/// sample from those before it, over its standard deviation. A linear map, so that a model and its derivatives pass it
/// as the data do.
///
/// The predictors of all orders up to 200 follow from the autocovariance by Durbin's recursion (J. Durbin, Rev. Inst.
/// Int. Stat. 28, 233, 1960); the first samples of a stretch are predicted from as many as there are.
class Whitener {
 public:
  /// Of noise of that colour, sampled every `interval` s. A level of white noise 30 dB below is added: what no clock
  /// and no integrator is exact enough to use.
  Whitener(const NoiseColour& colour, double interval);

  [[nodiscard]] const NoiseColour& colour() const noexcept { return colour_; }
  [[nodiscard]] double interval() const noexcept { return interval_; }  ///< s

  /// Replaces a stretch of consecutive samples, in units of the colour's sigma, by their prediction errors.
  void apply(Eigen::Ref<Eigen::VectorXd> stretch) const;

 private:
  NoiseColour colour_;
  double interval_;
  std::vector<double> reflections_;  // of orders 1, 2, ...
  std::vector<double> deviations_;   // of the prediction errors of orders 0, 1, ...; in units of sigma
};

}  // namespace coilwright::measurement::signals
