#pragma once

#include <Eigen/Core>
#include <vector>

#include "coilwright/actuator/assemble.hpp"
#include "coilwright/actuator/design/design.hpp"
#include "coilwright/magnetics/cylinder_magnet.hpp"

namespace coilwright::systems::gripper {

/// How the magnets of the second finger are built in, seen from the first.
enum class Polarity {
  same,     ///< two identical fingers: facing each other, their magnets repel
  opposite  ///< the second finger's coils and magnets are all turned: the magnets attract, currents act alike
};

/// How two like fingers are mounted.
struct Mounting {
  double angle{};    ///< of each straight finger with the gripper's axis, outwards, rad; between -pi/2 and pi/2
  double spacing{};  ///< between the two base joints, m; finite, > 0
  Polarity polarity = Polarity::same;
};

/// One magnet of a finger.
struct FingerMagnet {
  mechanics::LinkPoint centre;
  double sense = 1.0;  ///< +1: polarised along its link
};

/// Two fingers that hang from a palm and close towards each other, in one plane.
///
/// The first is left, at x = -spacing/2, the second is its mirror image. The gripping face of each segment is the lower
/// side of the bottom layer, half its thickness from the hinge line.
class Gripper {
 public:
  /// Throws std::invalid_argument for a mounting that breaks its rule, a design that cannot be built (naming the first
  /// fault), or one with effects that have states of their own.
  Gripper(const actuator::Design& finger, const Mounting& mounting);

  /// The left finger, its base turned by the mounting angle.
  [[nodiscard]] const actuator::Model& finger() const noexcept { return assembly_.model; }
  /// What that finger was assembled from.
  [[nodiscard]] const actuator::Assembly& assembly() const noexcept { return assembly_; }
  /// As given.
  [[nodiscard]] const Mounting& mounting() const noexcept { return mounting_; }
  [[nodiscard]] double gravity() const noexcept { return finger().chain().gravity(); }  ///< m/s^2
  [[nodiscard]] double face_offset() const noexcept { return face_offset_; }  ///< hinge line to gripping face, m
  /// Where the gripping face of a link begins and ends along it, m; link -1 is the base segment.
  struct Face {
    double begin{}, end{};  ///< m
  };
  /// Of a link of the finger, -1 to joints() - 1.
  [[nodiscard]] Face face(int link) const;
  /// Of one finger, base first.
  [[nodiscard]] const std::vector<FingerMagnet>& magnets() const noexcept { return magnets_; }

  /// What the magnets of one finger do to the other finger.
  struct Pull {
    mechanics::JointVector left, right;  ///< torques on the joints, N m
    double largest_force{};              ///< between two of the magnets, N
  };
  /// At these joint angles, rad. Exact for the magnets; coils on the other finger's magnets are left out (in the
  /// prototype at 1.4 A a coil's moment is 4 % of a magnet's).
  [[nodiscard]] Pull magnet_torques(const mechanics::JointVector& left, const mechanics::JointVector& right) const;

 private:
  actuator::Assembly assembly_;
  Mounting mounting_;
  double face_offset_;
  double base_length_;
  magnetics::CylinderMagnet magnet_;
  std::vector<FingerMagnet> magnets_;
};

}  // namespace coilwright::systems::gripper
