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

/// What the rules of a wrench may leave out.
struct Accuracy {
  double log_radial;  ///< logarithm of the share of a field that the rule across the source's winding may
  double log_along;   ///< the same of the rule along a target sheet
  /// Share of the highest harmonic seen round a ring: what aliases into the integral is of twice its order, about the
  /// square of this.
  double harmonic;
};

/// Errors below 1e-7 in random poses (tests/magnetics/wrench_test.cpp).
inline constexpr Accuracy accuracy_of_pose{.log_radial = -15.5, .log_along = -17.0, .harmonic = 3e-5};
/// A sixth fewer points, and 1e-8 more of the largest torque of a hinge (tests/magnetics/recoil_test.cpp). Fewer along
/// the sheet would show where parts nearly touch.
inline constexpr Accuracy accuracy_of_curve{.log_radial = -13.5, .log_along = -17.0, .harmonic = 2e-4};

/// Force and torque on a unit-current sheet from a source of unit current, over mu0, in the source's frame: the Lorentz
/// force K x H over the sheet, by Gauss-Legendre along its length and the trapezoidal rule round it. `axis` is a unit
/// vector. Orders follow from the distance to the source's edges and, round the sheet, from the decay of the harmonics.
[[nodiscard]] Wrench lorentz_wrench(const SheetBody& source, const TargetSheet& target, const Eigen::Vector3d& position,
                                    const Eigen::Vector3d& axis, const Accuracy& accuracy);

/// A loop of current round the target's axis.
struct CurrentRing {
  double radius;   ///< m
  double height;   ///< along the target's axis from its centre, m
  double current;  ///< A
};

/// The same on rings, which lie on a cylinder no larger than `target`.
[[nodiscard]] Wrench lorentz_wrench(const SheetBody& source, const TargetSheet& target,
                                    std::span<const CurrentRing> rings, const Eigen::Vector3d& position,
                                    const Eigen::Vector3d& axis, const Accuracy& accuracy);

}  // namespace coilwright::magnetics
