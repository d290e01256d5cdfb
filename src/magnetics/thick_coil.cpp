#include "coilwright/magnetics/thick_coil.hpp"

#include "magnetics/require.hpp"

namespace coilwright::magnetics {

ThickCoil::ThickCoil(const Spec& spec) : spec_(spec) {
  require_positive("coil inner_radius", spec.inner_radius);
  require_positive("coil outer_radius", spec.outer_radius);
  require(spec.outer_radius > spec.inner_radius, "coil outer_radius",
          fmt::format("> inner_radius ({})", spec.inner_radius), spec.outer_radius);
  require_positive("coil length", spec.length);
  require(spec.turns_radial >= 1, "coil turns_radial", ">= 1", spec.turns_radial);
  require(spec.turns_axial >= 1, "coil turns_axial", ">= 1", spec.turns_axial);
}

double ThickCoil::turns() const noexcept {
  return static_cast<double>(spec_.turns_radial) * spec_.turns_axial;
}

}  // namespace coilwright::magnetics
