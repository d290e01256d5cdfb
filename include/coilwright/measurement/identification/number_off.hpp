#pragma once

#include <optional>
#include <string>

#include "coilwright/measurement/identification/estimate.hpp"

namespace coilwright::measurement::identification {

/// A declared number that explains the data far better free than within its tolerance, by itself. Held by its
/// tolerance it passes what it lacks to its neighbours, none of which need move further than chance may have it.
struct NumberOff {
  std::string name{};  ///< its key, or the function of the torque's shape ("force_curve")
  /// Where the data put it, free, all others within their tolerances; its interval is from the curvature there. None of
  /// a function, which is several coefficients.
  std::optional<Estimate> estimate{};
  double gain{};  ///< of the quasi-BIC over the model in which it is held, charged as a number of an effect is
};

}  // namespace coilwright::measurement::identification
