#pragma once

#include <span>
#include <string_view>

#include "coilwright/sizing/study/spread.hpp"

namespace coilwright::sizing {

/// How an actuator is built from bought parts.
enum class Making {
  printed,  ///< cast in printed moulds: "usual"
  by_hand   ///< moulds, cores and the cut made and set by hand: "by_hand"
};

/// How a number of an actuator scatters where it is built in one of these ways.
struct UsualScatter {
  Scatter scatter;          ///< of one build about what was designed
  std::string_view source;  ///< where the figure is from, or that it is assumed
};

/// One row a number, of actuator::number_widths() and of what each joint or magnet has by itself; `coilwright list
/// spreads` prints them. `"parts": "usual"` or `"by_hand"` of a study's spread takes those of the whole actuator: what
/// each part has by itself, most_parts(), has to be named.
[[nodiscard]] std::span<const UsualScatter> usual_scatters(Making making = Making::printed);

}  // namespace coilwright::sizing
