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

/// One row a number; `coilwright list spreads` prints them. `"parts": "usual"` of a study's spread takes those of the
/// whole actuator: what each joint or magnet has by itself, most_parts(), has to be named.
[[nodiscard]] std::span<const UsualScatter> usual_scatters();

}  // namespace coilwright::sizing
