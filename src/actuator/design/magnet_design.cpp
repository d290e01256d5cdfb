#include "coilwright/actuator/design/design.hpp"
#include "coilwright/magnetics/inner_field.hpp"

namespace coilwright::actuator {

void MagnetDesign::make_of(const magnetics::MagnetGrade* material) {
  grade = material;
  if (material == nullptr) return;
  remanence = material->remanence;
  density = material->density;
  temperature_limit = material->temperature_limit;
}

double MagnetDesign::polarisation() const {
  if (grade == nullptr) return remanence;
  return remanence * magnetics::recoil_factor({.radius = radius, .length = length}, grade->recoil_permeability);
}

magnetics::CylinderMagnet MagnetDesign::cylinder() const {
  return magnetics::CylinderMagnet({.radius = radius,
                                    .length = length,
                                    .remanence = remanence,
                                    .recoil_permeability = grade == nullptr ? 1.0 : grade->recoil_permeability});
}

}  // namespace coilwright::actuator
