#include "coilwright/mechanics/face_contact.hpp"

#include <cmath>

namespace coilwright::mechanics {

double contact_damping(double stiffness, double mobility) {
  return 2.0 * contact_damping_ratio * std::sqrt(stiffness / mobility);
}

double wall_stiffness(const FaceWalls& walls) {
  return walls.young_modulus * walls.width * walls.height * walls.height * walls.height / (3.0 * walls.thickness);
}

}  // namespace coilwright::mechanics
