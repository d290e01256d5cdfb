#pragma once

#include <memory>

#include "coilwright/magnetics/curve.hpp"

namespace coilwright::actuator {

/// To which the curves of an actuator are made, relative to their largest value: two orders below the 1e-5 to which a
/// coil is wound.
inline constexpr double curve_tolerance = 1e-6;

/// Force between two coaxial components over the distance of their centres, and its energy.
struct AxialCurves {
  std::shared_ptr<const magnetics::Curve> force;   ///< on the second, N (per A for each coil)
  std::shared_ptr<const magnetics::Curve> energy;  ///< zero at infinity, J (likewise)
};

/// The force's curve with that of its energy: by quadrature, beyond the force's last distance that of two dipoles.
[[nodiscard]] AxialCurves axial_curves(magnetics::Curve force);

}  // namespace coilwright::actuator
