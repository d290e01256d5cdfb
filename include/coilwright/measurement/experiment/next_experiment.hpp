#pragma once

#include <string>

namespace coilwright::measurement::experiment {

/// The run that would separate what these data cannot.
struct NextExperiment {
  std::string kind{};   ///< from the menu: "release", "hot_hold", ...
  std::string input{};  ///< what to command, with numbers
  std::string why{};
  double separation{};  ///< rms difference of the rivals' predictions over the noise
};

}  // namespace coilwright::measurement::experiment
