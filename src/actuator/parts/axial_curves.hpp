#pragma once

#include <memory>

#include "coilwright/magnetics/curve.hpp"

namespace coilwright::actuator {

/// Force between two coaxial components over the distance of their centres, and its energy.
struct AxialCurves {
  std::shared_ptr<const magnetics::Curve> force;   ///< on the second, N (per A for each coil)
  std::shared_ptr<const magnetics::Curve> energy;  ///< zero at infinity, J (likewise)
};

/// The force's curve with that of its energy, made to `tolerance` as the force's was: by quadrature, beyond the force's
/// last distance that of two dipoles.
[[nodiscard]] AxialCurves axial_curves(magnetics::Curve force, double tolerance);

}  // namespace coilwright::actuator
