#pragma once

#include "coilwright/magnetics/wrench.hpp"
#include "magnetics/sheets.hpp"
#include "magnetics/surface_quadrature.hpp"

namespace coilwright::magnetics {

/// Axial force on the second of two coaxial bodies, as axial_force() of theirs.
[[nodiscard]] double axial_force_of_sheets(const SheetBody& first, const SheetBody& second, double distance);

/// Force and torque on the second of two bodies, as wrench() of theirs without what recoil adds.
[[nodiscard]] Wrench wrench_of_sheets(const SheetBody& first, const SheetBody& second, const Pose& pose,
                                      const Accuracy& accuracy = accuracy_of_pose);

/// The sense of a second body on the common axis (+1 or -1 as its own axis points along z or against it), 0 off the
/// axis. There the closed form is exact to 1e-10 where the quadrature over a sheet is not, with faces level or
/// touching.
[[nodiscard]] double sense_on_axis(const Pose& pose);

}  // namespace coilwright::magnetics
