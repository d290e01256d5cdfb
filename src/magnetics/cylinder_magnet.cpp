#include "coilwright/magnetics/cylinder_magnet.hpp"

#include "magnetics/require.hpp"

namespace coilwright::magnetics {

CylinderMagnet::CylinderMagnet(const Spec& spec) : spec_(spec) {
  require_positive("magnet radius", spec.radius);
  require_positive("magnet length", spec.length);
  require_positive("magnet remanence", spec.remanence);
}

}  // namespace coilwright::magnetics
