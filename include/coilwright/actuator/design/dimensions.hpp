#pragma once

#include <string>
#include <vector>

#include "coilwright/actuator/design/design.hpp"
#include "coilwright/winding/winding.hpp"

namespace coilwright::actuator {

/// A rule of construction that a design breaks.
struct ConstructionFault {
  std::string rule;  ///< one line: the rule with both figures and units
  double excess{};   ///< by how much, relative to the limit; > 0 and growing away from what can be built
};

/// All faults of a design; empty for one that can be built.
using ConstructionFaults = std::vector<ConstructionFault>;

/// Returns all rules that `design` breaks: sizes that are not finite and positive, turns outside 1 to 10,000, wires
/// that do not exist, a bore too tight for its wire, hardnesses outside their relations, an invalid layout, and invalid
/// calibration factors or surroundings. Empty for a design that can be built. Never throws.
[[nodiscard]] ConstructionFaults construction_faults(const Design& design);

/// Geometry that follows from a design, SI; the names of the paper's Tables I and II in brackets.
struct Dimensions {
  double coil_outer_radius{};  ///< (R_c)
  double coil_length{};        ///< (l_c)
  double body_radius{};        ///< of the widest part: max of coil and magnet
  double width{};              ///< of the cross-section (w_e)
  double height{};             ///< of the cross-section (h_e)
  double axis_offset{};        ///< hinge line to coil axis (h)
  double coil_half_pitch{};    ///< half a coil segment (l_0 = l_3)
  double magnet_half_pitch{};  ///< half a magnet segment (l_1)
  double tip_length{};         ///< last joint to the fingertip
  double effective_length{};   ///< all components and the front part (l_e)
  double total_length{};       ///< with the rear part
  double face_height{};        ///< hinge line to the top of the smaller of coil and magnet
  /// Angle, rad, > 0, by which a joint between coil and magnet closes from 0 until they touch there: gap over height,
  /// to first order (the next term is below 0.1 % at 3 degrees).
  double closing_angle{};
};

/// Computes the dimensions. Precondition: construction_faults(design) is empty. Throws std::invalid_argument naming the
/// rule if the winding is invalid.
[[nodiscard]] Dimensions dimensions(const Design& design);

/// Thickness of silicone between the two components that joint `joint` separates (0 is the joint at the base), with the
/// joint straight, m: the walls of both. Between a coil and a magnet it is the design's gap, between two coils 2/3 of
/// it. Precondition as above, and 0 <= joint < components - 1.
[[nodiscard]] double gap_of_joint(const Design& design, int joint);

/// Height of the faces that meet at that joint, m, from the hinge line to the top of the smaller component.
[[nodiscard]] double face_height_of_joint(const Design& design, const Dimensions& dimensions, int joint);

/// Angle by which that joint closes from 0 until its two components touch at their top, rad, > 0, to first order.
/// Between a coil and a magnet it is Dimensions::closing_angle.
[[nodiscard]] double closing_angle_of_joint(const Design& design, const Dimensions& dimensions, int joint);

/// The coil of a design, its pitches scaled by the calibration. Precondition as above.
[[nodiscard]] winding::Winding winding_of(const Design& design);

}  // namespace coilwright::actuator
