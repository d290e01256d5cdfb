#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "coilwright/measurement/data/run.hpp"

namespace coilwright::measurement {

/// Errors of one model in one kind of channel, SI.
struct Errors {
  double mae{};   ///< mean absolute error
  double rmse{};  ///< root mean square error
  double max{};   ///< largest absolute error
};

/// Errors of the three models on the same runs.
struct ErrorComparison {
  data::ChannelKind kind{};  ///< joint_angle for both kinds of angles, whose errors are taken together
  std::size_t samples{};
  Errors declared{}, before{}, after{};
  std::optional<Errors> corrected{};  ///< of `after` with a nameless correction of the torque, where there is one
  double noise_floor_rmse{};
  /// Standard deviation of the predictions of `after` due to parameter uncertainty (first order), rms over these runs.
  double uncertainty_rmse{};
};

/// One channel of one run with the predictions of the three models, SI, as residuals.csv lists it.
struct Replay {
  std::string run{};
  bool validate{};
  data::ChannelKind kind{};
  std::string channel{};
  std::vector<double> at{};  ///< s, or rad or A on a bench without time
  std::vector<double> measured{}, declared{}, before{}, after{};
  std::vector<double> corrected{};  ///< empty where there is no nameless correction
  /// For each sample whether it was taken as an outlier, and counts in no fit and no error; empty: none was.
  std::vector<char> left_out{};
};

/// Samples of one channel that stand apart from their neighbours as no motion does, and were left out.
struct Outliers {
  std::string run{};
  std::string channel{};
  bool validate{};              ///< left out of the errors; otherwise of the fits, and of their errors
  std::vector<double> times{};  ///< s
};

}  // namespace coilwright::measurement
