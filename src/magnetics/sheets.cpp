#include "magnetics/sheets.hpp"

#include "coilwright/magnetics/constants.hpp"
#include "coilwright/magnetics/inner_field.hpp"

namespace coilwright::magnetics {

SheetBody sheets_of(const ThickCoil& coil, double current) noexcept {
  SheetBody body{.inner_radius = coil.inner_radius(),
                 .outer_radius = coil.outer_radius(),
                 .half_length = 0.5 * coil.length(),
                 .surface_current = coil.turns() * current / coil.length(),
                 .shells = coil.turns_radial(),
                 .spread = coil.winding() == CurrentDistribution::uniform ? Spread::uniform : Spread::shells};
  const bool one_shell = coil.turns_radial() == 1 && coil.winding() == CurrentDistribution::paper_shells;
  if (one_shell || coil.winding() == CurrentDistribution::layer_centres) {
    const double half_layer = 0.5 * (coil.outer_radius() - coil.inner_radius()) / coil.turns_radial();
    body.inner_radius += half_layer;
    body.outer_radius -= half_layer;
  }
  return body;
}

SheetBody sheets_of(const CylinderMagnet& magnet) noexcept {
  return {.inner_radius = magnet.radius(),
          .outer_radius = magnet.radius(),
          .half_length = 0.5 * magnet.length(),
          .surface_current = magnet.remanence() / vacuum_permeability,
          .shells = 1,
          .spread = Spread::shells};
}

SheetBody weakened_sheets_of(const CylinderMagnet& magnet) {
  SheetBody body = sheets_of(magnet);
  body.surface_current *=
      recoil_factor({.radius = magnet.radius(), .length = magnet.length()}, magnet.recoil_permeability());
  return body;
}

}  // namespace coilwright::magnetics
