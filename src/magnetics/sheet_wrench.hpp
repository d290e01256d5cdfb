#pragma once

#include "coilwright/magnetics/wrench.hpp"
#include "magnetics/sheets.hpp"

namespace coilwright::magnetics {

/// Axial force on the second of two coaxial bodies, as axial_force() of theirs.
[[nodiscard]] double axial_force_of_sheets(const SheetBody& first, const SheetBody& second, double distance);

/// Force and torque on the second of two bodies, as wrench() of theirs without what recoil adds.
[[nodiscard]] Wrench wrench_of_sheets(const SheetBody& first, const SheetBody& second, const Pose& pose);

}  // namespace coilwright::magnetics
