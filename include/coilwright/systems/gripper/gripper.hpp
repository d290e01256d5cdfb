#pragma once

#include <Eigen/Core>
#include <array>
#include <string_view>
#include <vector>

#include "coilwright/actuator/assemble.hpp"
#include "coilwright/actuator/design/design.hpp"
#include "coilwright/magnetics/cylinder_magnet.hpp"

namespace coilwright::systems::gripper {

/// Polarity of the second finger's magnets relative to the first's.
enum class Polarity {
  same,     ///< identical fingers: facing each other, their magnets repel
  opposite  ///< every second finger's coils and magnets are all turned: two that face each other attract, currents act
            ///< alike
};

/// The words of the polarities.
inline constexpr std::array<std::string_view, 2> polarity_words{"same", "opposite"};

/// Places and angles at which like fingers are mounted.
struct Mounting {
  double angle{};    ///< of each straight finger with the gripper's axis, outwards, rad; between -pi/2 and pi/2
  double spacing{};  ///< diameter of the circle on which the base joints lie, of two fingers their distance, m; > 0
  Polarity polarity = Polarity::same;  ///< opposite: of an even number of fingers
  int fingers = 2;                     ///< evenly round the axis; 2 to most_fingers
};
inline constexpr int most_fingers = 8;

/// One magnet of a finger.
struct FingerMagnet {
  mechanics::LinkPoint centre;
  double sense = 1.0;  ///< +1: polarised along its link
};

/// Fingers that hang from a palm and close towards its axis, each in a plane through it.
///
/// The first is left, at x = -spacing/2; the second of two is its mirror image. More than two stand evenly round the
/// axis and all move alike; statements about the left one apply to each. The gripping face of each segment is the lower
/// side of the bottom layer, half its thickness from the hinge line, as wide as the finger.
class Gripper {
 public:
  /// Makes the gripper. Throws std::invalid_argument for a mounting that breaks its rule, a design that cannot be built
  /// (naming the first fault), or one with effects that have states of their own.
  Gripper(const actuator::Design& finger, const Mounting& mounting);

  /// The left finger, its base turned by the mounting angle.
  [[nodiscard]] const actuator::Model& finger() const noexcept { return assembly_.model; }
  /// The assembly of that finger.
  [[nodiscard]] const actuator::Assembly& assembly() const noexcept { return assembly_; }
  /// The mounting as given.
  [[nodiscard]] const Mounting& mounting() const noexcept { return mounting_; }
  [[nodiscard]] double gravity() const noexcept { return finger().chain().gravity(); }  ///< m/s^2
  [[nodiscard]] double face_offset() const noexcept { return face_offset_; }  ///< hinge line to gripping face, m
  /// Begin and end of the gripping face along a link, m; link -1 is the base segment.
  struct Face {
    double begin{}, end{};  ///< m
  };
  /// The face of a link of the finger, -1 to joints() - 1.
  [[nodiscard]] Face face(int link) const;
  /// The magnets of one finger, base first.
  [[nodiscard]] const std::vector<FingerMagnet>& magnets() const noexcept { return magnets_; }

  /// Overlap of the sides of neighbouring fingers at these joint angles, m; negative: the gap between them. Minus
  /// infinity for two fingers, which face each other.
  [[nodiscard]] double overlap_of_neighbours(const mechanics::JointVector& angles) const;

  /// Load of a finger by the magnets of the other fingers.
  struct Pull {
    mechanics::JointVector left, right;  ///< torques on the joints, N m
    double largest_force{};              ///< between two of the magnets, N
  };
  /// The load at these joint angles, rad. Of more than two fingers all others are bent like the one in question. Exact
  /// for the magnets; coils on the other finger's magnets are left out (in the prototype at 1.4 A a coil's moment is 4
  /// % of a magnet's).
  [[nodiscard]] Pull magnet_torques(const mechanics::JointVector& left, const mechanics::JointVector& right) const;

 private:
  [[nodiscard]] mechanics::JointVector torques_among_alike(const mechanics::JointVector& angles,
                                                           double& largest_force) const;

  actuator::Assembly assembly_;
  Mounting mounting_;
  double face_offset_;
  double base_length_;
  magnetics::CylinderMagnet magnet_;
  std::vector<FingerMagnet> magnets_;
};

}  // namespace coilwright::systems::gripper
