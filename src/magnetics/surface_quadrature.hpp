#pragma once

#include <span>

#include "coilwright/magnetics/wrench.hpp"
#include "magnetics/sheets.hpp"

namespace coilwright::magnetics {

/// One cylindrical current sheet in the field of a source.
struct TargetSheet {
  double radius;       ///< m
  double half_length;  ///< m
};

/// Force and torque on a unit-current sheet from a source of unit current, over mu0, in the source's frame: the Lorentz
/// force K x H over the sheet, by Gauss-Legendre along its length and the trapezoidal rule round it. `axis` is a unit
/// vector. Orders follow from the distance to the source's edges and, round the sheet, from the decay of the harmonics.
[[nodiscard]] Wrench lorentz_wrench(const SheetBody& source, const TargetSheet& target, const Eigen::Vector3d& position,
                                    const Eigen::Vector3d& axis);

/// A loop of current round the target's axis.
struct CurrentRing {
  double radius;   ///< m
  double height;   ///< along the target's axis from its centre, m
  double current;  ///< A
};

/// The same on rings, which lie on a cylinder no larger than `target`.
[[nodiscard]] Wrench lorentz_wrench(const SheetBody& source, const TargetSheet& target,
                                    std::span<const CurrentRing> rings, const Eigen::Vector3d& position,
                                    const Eigen::Vector3d& axis);

}  // namespace coilwright::magnetics
