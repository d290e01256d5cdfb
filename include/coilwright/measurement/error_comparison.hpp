#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "coilwright/measurement/data/run.hpp"

namespace coilwright::measurement {

/// Of one quantity, SI.
struct Errors {
  double mae{};
  double rmse{};
  double max{};
};

/// Errors of the three models on the same runs.
struct ErrorComparison {
  data::Quantity quantity{};
  std::size_t samples{};
  Errors declared{}, before{}, after{};
  double noise_floor_rmse{};
  /// Of `after`: what the uncertainty of its fitted numbers leaves open on these runs (one standard deviation, to first
  /// order, rms over the samples).
  double uncertainty_rmse{};
};

/// One channel of one run with the three predictions, SI: for residuals.csv and pictures.
struct Replay {
  std::string run{};
  bool validate{};
  data::Quantity quantity{};
  std::string channel{};
  std::vector<double> at{};  ///< s, or rad or A on a bench without time
  std::vector<double> measured{}, declared{}, before{}, after{};
};

}  // namespace coilwright::measurement
