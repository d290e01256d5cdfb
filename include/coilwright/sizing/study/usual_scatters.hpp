#pragma once

#include <span>
#include <string_view>

#include "coilwright/sizing/study/spread.hpp"

namespace coilwright::sizing {

/// The method by which an actuator is built from bought parts.
enum class Making {
  printed,  ///< cast in printed moulds: "usual"
  by_hand   ///< moulds, cores and the cut made and set by hand: "by_hand"
};

/// The usual scatter of a number of an actuator that is built by one of these methods.
struct UsualScatter {
  Scatter scatter;          ///< scatter of one build about its design
  std::string_view source;  ///< source of the figure, or that it is assumed
};

/// One row for each of actuator::number_widths() and for each number of single joints or magnets; `coilwright list
/// spreads` prints them. `"parts": "usual"` or `"by_hand"` of a study's spread takes those of the whole actuator;
/// numbers with most_parts() have to be named.
[[nodiscard]] std::span<const UsualScatter> usual_scatters(Making making = Making::printed);

}  // namespace coilwright::sizing
