#pragma once

namespace coilwright::magnetics {

/// Magnetic constant, N/A^2: CODATA 2018, 1.256 637 062 12(19)e-6. A coil-magnet force does not depend on it (it
/// cancels between remanence and sheet current); magnet-magnet goes as 1/mu0, coil-coil as mu0.
inline constexpr double vacuum_permeability = 1.25663706212e-6;

}  // namespace coilwright::magnetics
