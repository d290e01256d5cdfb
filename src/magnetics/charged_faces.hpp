#pragma once

#include "coilwright/magnetics/body.hpp"
#include "coilwright/magnetics/wrench.hpp"

namespace coilwright::magnetics {

/// A wrench by numerical integration, and how wrong it may be.
struct EstimatedWrench {
  Wrench wrench;
  double error{};  ///< N, of the force; of the torque it is times the size of the body
};

/// Force and torque on a magnet of uniform magnetisation in the field of another body, which must not overlap it: that
/// on the magnetic charge J . n of its faces, B / mu0 a unit of it. In the axes of both poses, torque about the
/// magnet's centre. Adaptive Gauss-Legendre to 1e-8 of the sum of the magnitudes; where bodies touch the field is
/// singular along the edges, and it stops at a quarter of a million points; `error` says how far it has come.
[[nodiscard]] EstimatedWrench wrench_on_faces(const Body& source, const Magnet& magnet, const Pose& pose);

}  // namespace coilwright::magnetics
