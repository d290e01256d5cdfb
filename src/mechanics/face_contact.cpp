#include "coilwright/mechanics/face_contact.hpp"

namespace coilwright::mechanics {

double wall_stiffness(const FaceWalls& walls) {
  return walls.young_modulus * walls.width * walls.height * walls.height * walls.height / (3.0 * walls.thickness);
}

}  // namespace coilwright::mechanics
