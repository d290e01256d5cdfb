#pragma once

#include <optional>

namespace coilwright::mechanics {

/// A block of rubber, cut from above down to a ligament, that is bent about the ligament: half of it, x from the plane
/// of the cut to the far end, which stays plane, y from the bottom. Lengths in one unit, mm say.
struct HingeBlock {
  double ligament{};       ///< h_b: what the cut leaves
  double slot_width{};     ///< of the cut, both sides together; 0 for a slit
  double height{};         ///< of the body
  double half_length{};    ///< from the plane of the cut to the far end
  double poisson_ratio{};  ///< below 0.5
  /// Young's modulus of what lies above the ligament's height, over that of the layer below.
  double modulus_above = 1.0;
  /// A rigid body inside, each side of the cut, from half the slot's width plus `wall` to the far end.
  struct Core {
    double wall{};    ///< between it and the face of the cut
    double bottom{};  ///< y of its lower face
    double top{};     ///< y of its upper face
  };
  std::optional<Core> core{};  ///< nothing: rubber all through
};

/// Bending stiffness of the whole block over E' w, where E' = E / (1 - nu^2) and w is the width, in the square of the
/// length's unit; the block's moment divided by the angle between its halves is this times E' w.
///
/// Plane strain, elements of eight nodes integrated at 2 x 2 points (which do not lock towards nu = 0.5: Zienkiewicz
/// and Taylor, The Finite Element Method, section on selective and reduced integration), graded towards the edge of the
/// cut. `levels` elements stand between that edge and each border of the ligament; each is `ratio` times its neighbour
/// nearer to the edge.
[[nodiscard]] double hinge_stiffness_by_elements(const HingeBlock& block, int levels, double ratio = 1.5);

}  // namespace coilwright::mechanics
