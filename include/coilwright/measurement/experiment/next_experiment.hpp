#pragma once

#include <string>

namespace coilwright::measurement::experiment {

/// A run that would separate hypotheses that the present data cannot separate.
struct NextExperiment {
  std::string kind{};   ///< one of the candidate experiments: "release", "hot_hold", ...
  std::string input{};  ///< the command, with numbers
  std::string why{};
  double separation{};  ///< rms difference of the hypotheses' predictions over the noise
};

}  // namespace coilwright::measurement::experiment
