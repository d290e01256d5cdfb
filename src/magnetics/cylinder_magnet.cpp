#include "coilwright/magnetics/cylinder_magnet.hpp"

#include "magnetics/require.hpp"

namespace coilwright::magnetics {

CylinderMagnet::CylinderMagnet(const Spec& spec) : spec_(spec) {
  require_positive("magnet radius", spec.radius);
  require_positive("magnet length", spec.length);
  require_positive("magnet remanence", spec.remanence);
  require(spec.recoil_permeability >= 1.0 && spec.recoil_permeability <= most_recoil_permeability,
          "magnet recoil_permeability", "1 to 1.2", spec.recoil_permeability);
}

CylinderMagnet CylinderMagnet::without_recoil() const {
  return CylinderMagnet({.radius = spec_.radius, .length = spec_.length, .remanence = spec_.remanence});
}

}  // namespace coilwright::magnetics
