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

/// The same design, calibrated so that its hinges have the stiffness (N m/rad) and damping (N m s/rad) that were
/// measured on it; what is absent stays by its law. Of the damping the silicone keeps its law's part and the rest is
/// constant; all of it is the silicone's where BodyDesign::constant_damping is 0 or the law's part is the larger. This
/// design is the reference from then on. Throws std::invalid_argument naming a value that is not finite and > 0.
/// Precondition as above.
[[nodiscard]] Design with_measured_hinge(Design design, std::optional<double> stiffness, std::optional<double> damping);

/// The joint about which laws are exchanged: the one of the design's calibration. Without one (nothing measured, a file
/// of 0.1) the prototype's, with the stiffness that was measured on it and the damping that this design's own loss and
/// constant give there, whatever its silicone: the default constant is what the prototype's damping leaves.
[[nodiscard]] HingeReference hinge_reference(const Design& design);

/// Whether the stiffness of the design's hinges rests on a measurement: a joint was measured, and the hinge is of the
/// silicone and the law that it had then. Precondition: construction_faults(design) is empty.
[[nodiscard]] bool has_measured_stiffness(const Design& design);

/// Whether their damping does.
[[nodiscard]] bool has_measured_damping(const Design& design);

/// The same design under another law of its hinges. Where a stiffness was measured (Calibration::joint_stiffness is not
/// 1), the joint of hinge_reference() keeps its stiffness and damping, and so does this design if it has that
/// cross-section. Otherwise the other law gives the stiffness by itself, as it does in a file that names it, and a
/// damping that was measured stays.
[[nodiscard]] Design with_hinge_law(Design design, HingeLaw law);

/// What of a measured damping follows the hinge, and how.
struct DampingSplit {
  DampingLaw law{};
  double share{};  ///< 0 to 1; 0: all of it is constant, whatever the law
};

/// The split of a design's damping at hinge_reference().
[[nodiscard]] DampingSplit damping_split(const Design& design);

/// The same design with its damping split otherwise. The joint of hinge_reference() keeps its damping. Throws
/// std::invalid_argument naming the rule for a share outside 0 to 1.
[[nodiscard]] Design with_damping(Design design, const DampingSplit& split);

/// The same design with other stops of its joints. Nothing that is calibrated depends on them.
[[nodiscard]] Design with_face_contact(Design design, ContactChoice faces);

}  // namespace coilwright::actuator
