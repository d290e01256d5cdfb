#pragma once

#include <optional>

#include "coilwright/actuator/design/design.hpp"
#include "coilwright/actuator/design/dimensions.hpp"
#include "coilwright/mechanics/planar_chain.hpp"

namespace coilwright::actuator {

/// Stiffness of a hinge by the design's law, calibrated, N m/rad. Every hinge is alike.
/// Precondition: construction_faults(design) is empty.
[[nodiscard]] double hinge_stiffness(const Design& design, const Dimensions& dimensions);

/// Damping of a hinge, N m s/rad, in a finger whose first mode has the frequency `first_mode` (Hz, > 0): the silicone's
/// part by the design's law, and the part that does not follow the hinge. Precondition as above.
[[nodiscard]] double hinge_damping(const Design& design, const Dimensions& dimensions, double first_mode);

/// Lowest natural frequency of the chain on hinges of `stiffness` (N m/rad), Hz, hanging straight in its gravity
/// whatever its base tilt, without damping, magnets and contact: the frequency at which DampingLaw::loss_factor takes
/// the silicone's loss. It depends neither on the current nor on a pose, as the actual one does (prototype: 5.0 Hz; 5.2
/// about its rest pose, 6.6 about its steady angle at 1.4 A).
[[nodiscard]] double first_mode_frequency(const mechanics::PlanarChain& chain, double stiffness);

/// Returns the same design, calibrated so that its hinges have the measured stiffness (N m/rad) and damping (N m
/// s/rad); an absent value stays by its law. The silicone keeps its law's part of the damping, and the rest is
/// constant. All of it is the silicone's if BodyDesign::constant_damping is 0 or the law's part is larger than the
/// damping. This design is the reference from then on. Throws std::invalid_argument naming a value that is not finite
/// and > 0. Precondition as above.
[[nodiscard]] Design with_measured_hinge(Design design, std::optional<double> stiffness, std::optional<double> damping);

/// The joint about which laws are exchanged: that of the design's calibration. If nothing was measured, it is the
/// prototype's joint with its measured stiffness and the damping that this design's own loss and constant give there,
/// whatever its silicone.
[[nodiscard]] HingeReference hinge_reference(const Design& design);

/// Whether the stiffness of the design's hinges rests on a measurement: a joint was measured, and the hinge still has
/// the silicone and the law of that joint. Precondition: construction_faults(design) is empty.
[[nodiscard]] bool has_measured_stiffness(const Design& design);

/// Whether the damping of the hinges rests on a measurement in the same sense.
[[nodiscard]] bool has_measured_damping(const Design& design);

/// Returns the same design under another law of its hinges. If a stiffness was measured (Calibration::joint_stiffness
/// is not 1), the joint of hinge_reference() keeps its stiffness and damping, and so does this design if it has that
/// cross-section. Otherwise the other law gives the stiffness by itself, and a measured damping stays.
[[nodiscard]] Design with_hinge_law(Design design, HingeLaw law);

/// The part of a measured damping that follows the hinge, and its law.
struct DampingSplit {
  DampingLaw law{};
  double share{};  ///< 0 to 1; 0: all of it is constant, whatever the law
};

/// The split of a design's damping at hinge_reference().
[[nodiscard]] DampingSplit damping_split(const Design& design);

/// Returns the same design with its damping split otherwise. The joint of hinge_reference() keeps its damping. Throws
/// std::invalid_argument naming the rule for a share outside 0 to 1.
[[nodiscard]] Design with_damping(Design design, const DampingSplit& split);

/// Returns the same design with other stops of its joints. No calibrated value depends on them.
[[nodiscard]] Design with_face_contact(Design design, ContactChoice faces);

}  // namespace coilwright::actuator
