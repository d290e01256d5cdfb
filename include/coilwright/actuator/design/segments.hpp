#pragma once

#include <vector>

#include "coilwright/actuator/design/design.hpp"
#include "coilwright/actuator/design/dimensions.hpp"

namespace coilwright::actuator {

/// Mass of one segment, about its own joint; SI.
struct Segment {
  double length{};         ///< own joint to next, m
  double mass{};           ///< kg, calibrated
  double com_along{};      ///< from the own joint, m
  double com_offset{};     ///< from the hinge line, m
  double inertia{};        ///< about the centre of mass, in the plane of bending, kg m^2
  double silicone_mass{};  ///< mass of its silicone, kg
  double bottom_mass{};    ///< mass of its bottom layer if that is of another silicone than the body, kg; else 0
  double heat_capacity{};  ///< J/K
};

/// All segments, base first. The base segment (the first component with the rear part) does not move; its length counts
/// from its rear end. The last segment carries the front part.
///
/// Each is a silicone box of the body's cross-section with its coil or magnet cast in on the axis and the bore of a
/// coil filled, on a bottom layer that may be of another silicone. Wires do not count. Under
/// SegmentMass::on_axis_points the offset is that of the axis and the inertia is zero.
[[nodiscard]] std::vector<Segment> segments(const Design& design, const Dimensions& dimensions);

}  // namespace coilwright::actuator
