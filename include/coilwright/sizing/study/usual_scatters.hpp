#pragma once

#include <span>
#include <string_view>

#include "coilwright/sizing/study/spread.hpp"

namespace coilwright::sizing {

/// How a number of an actuator usually scatters where it is built by hand from bought parts.
struct UsualScatter {
  Scatter scatter;          ///< of one build about what was designed
  std::string_view source;  ///< where the figure is from, or that it is assumed
};

/// One row a number. `"parts": "usual"` of a study's spread takes them all, `coilwright list spreads` prints them.
[[nodiscard]] std::span<const UsualScatter> usual_scatters();

}  // namespace coilwright::sizing
